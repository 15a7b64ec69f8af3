# SPDX-License-Identifier: MIT
"""The certificates of clients: whether one may be used, and whether it is trusted.

In: the certificate of a client's channel, the name that its application gives, the files of a trust
list. Out: why it is refused, as OPC UA Part 4, 6.1.3 orders the steps. The name of a host is the
client's to compare, with the server's certificate; a server does not know it of a client.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from datetime import UTC, datetime

from asyncua import ua
from cryptography import x509
from cryptography.exceptions import InvalidSignature
from cryptography.hazmat.primitives.asymmetric.rsa import RSAPublicKey
from cryptography.x509.oid import ExtendedKeyUsageOID

from nctakt.base.dataclass import dataclass

#: The keys and hashes that Basic256Sha256 permits (Part 7, 6.6.165), keys in bits.
_KEY_BITS, _HASHES = range(2048, 4097), ("sha256", "sha384", "sha512")

_BEGIN_PEM, _BEGIN_CRL = b"-----BEGIN", b"-----BEGIN X509 CRL"


@dataclass(frozen=True, slots=True)
class Refusal:
    """Why a certificate is refused: for the log; ``status``: the code for the client."""

    reason: str
    status: int


@dataclass(frozen=True, slots=True)
class TrustList:
    """Certificates that are trusted, those of authorities among them, and what these revoke."""

    certificates: Sequence[x509.Certificate]
    revocations: Sequence[x509.CertificateRevocationList]


_CODES = ua.StatusCodes
_UNREADABLE = Refusal("its certificate cannot be read", _CODES.BadCertificateInvalid)
_WEAK = Refusal(
    "the key or hash of its certificate is not permitted", _CODES.BadCertificatePolicyCheckFailed
)
_UNTRUSTED = Refusal("its certificate is not trusted", _CODES.BadSecurityChecksFailed)
_TIME = Refusal("its certificate is not valid at this time", _CODES.BadCertificateTimeInvalid)
_URI = Refusal("its certificate is another application's", _CODES.BadCertificateUriInvalid)
_USE = Refusal("its certificate is for another use", _CODES.BadCertificateUseNotAllowed)
_REVOKED = Refusal("its certificate is revoked", _CODES.BadCertificateRevoked)
ANOTHER_CERTIFICATE = Refusal(
    "it names another certificate than its channel's", _CODES.BadCertificateInvalid
)


def read_trust_list(files: Mapping[str, bytes]) -> TrustList:
    """Return the content of files, DER or PEM; raises ``ValueError`` if it is neither."""
    certificates: list[x509.Certificate] = []
    revocations = []
    for name, content in files.items():
        try:
            if _BEGIN_CRL in content:
                revocations.append(x509.load_pem_x509_crl(content))
            elif _BEGIN_PEM in content:
                certificates += x509.load_pem_x509_certificates(content)
            elif name.endswith(".crl"):
                revocations.append(x509.load_der_x509_crl(content))
            else:
                certificates.append(x509.load_der_x509_certificate(content))
        except ValueError as error:
            raise ValueError(f"{name} is no certificate and no list of revocations") from error
    return TrustList(certificates, revocations)


def refusal_of(
    content: bytes, application: str | None, trusted: TrustList | None
) -> Refusal | None:
    """Return why a certificate is refused, if it is; without ``trusted`` any is trusted."""
    try:
        certificate = x509.load_der_x509_certificate(content)
        key = certificate.public_key()
        hash_used = certificate.signature_hash_algorithm
        is_weak = (
            not isinstance(key, RSAPublicKey)
            or key.key_size not in _KEY_BITS
            or hash_used is None
            or hash_used.name not in _HASHES
        )
        if is_weak:
            return _WEAK
        if trusted is not None and not _is_trusted(certificate, trusted):
            return _UNTRUSTED
        if not _is_of_now(certificate):
            return _TIME
        if application not in _uris(certificate):
            return _URI
        if not _is_for_clients(certificate):
            return _USE
    except Exception:  # noqa: BLE001 - the library has many for what a client may have made up
        return _UNREADABLE
    return _REVOKED if trusted is not None and _is_revoked(certificate, trusted) else None


def _is_trusted(certificate: x509.Certificate, trusted: TrustList) -> bool:
    """Return whether it is in the list, or a valid authority of the list has issued it."""
    if certificate in trusted.certificates:
        return True
    return any(
        _is_authority(one) and _is_of_now(one) and _has_issued(one, certificate)
        for one in trusted.certificates
    )


def _is_authority(certificate: x509.Certificate) -> bool:
    try:
        return certificate.extensions.get_extension_for_class(x509.BasicConstraints).value.ca
    except x509.ExtensionNotFound:
        return False


def _has_issued(authority: x509.Certificate, certificate: x509.Certificate) -> bool:
    try:
        certificate.verify_directly_issued_by(authority)
    except (InvalidSignature, TypeError, ValueError):
        return False
    return True


def _is_of_now(certificate: x509.Certificate) -> bool:
    now = datetime.now(UTC)
    return certificate.not_valid_before_utc <= now <= certificate.not_valid_after_utc


def _uris(certificate: x509.Certificate) -> list[str]:
    try:
        names = certificate.extensions.get_extension_for_class(x509.SubjectAlternativeName)
    except x509.ExtensionNotFound:
        return []
    return names.value.get_values_for_type(x509.UniformResourceIdentifier)


def _is_for_clients(certificate: x509.Certificate) -> bool:
    """Return whether it may sign, and authenticate a client, as far as it states its purpose."""
    for extension in certificate.extensions:
        value = extension.value
        if isinstance(value, x509.KeyUsage) and not value.digital_signature:
            return False
        if isinstance(value, x509.ExtendedKeyUsage) and (
            ExtendedKeyUsageOID.CLIENT_AUTH not in value
        ):
            return False
    return True


def _is_revoked(certificate: x509.Certificate, trusted: TrustList) -> bool:
    """Return whether a list of revocations names it that its authority has signed."""
    return any(
        one.get_revoked_certificate_by_serial_number(certificate.serial_number) is not None
        for one in trusted.revocations
        for authority in trusted.certificates
        if one.issuer == certificate.issuer == authority.subject
        and isinstance(key := authority.public_key(), RSAPublicKey)
        and one.is_signature_valid(key)
    )
