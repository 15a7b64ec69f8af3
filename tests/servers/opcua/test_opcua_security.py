# SPDX-License-Identifier: MIT
"""OPC UA off this computer: what is not encrypted, not trusted or nobody's does not come in.

OPC UA Part 4, 6.1.3 (steps of checking a certificate), 5.6 (sessions), Part 7 (Basic256Sha256).
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Sequence
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("asyncua", reason="OPC UA needs the extra opcua")

from asyncua import ua
from cryptography import x509
from cryptography.hazmat.primitives import hashes
from cryptography.hazmat.primitives.asymmetric import rsa
from cryptography.hazmat.primitives.serialization import Encoding, NoEncryption, PrivateFormat
from cryptography.x509.oid import ExtendedKeyUsageOID, NameOID
from support.opcua_client import patient_client
from support.served import Served

from nctakt.base.failure import Failure
from nctakt.servers.opcua.clients.certificates import read_trust_list, refusal_of
from nctakt.servers.opcua.clients.security import PASSWORD, TRUSTED, Security
from nctakt.servers.opcua.limits import Limits

URI = "urn:example:hmi"
NOW = datetime.now(UTC)
OVERRIDE = "ns=3;s=CncChannelList.1.HLI.OVERRIDE"

#: Names of status codes that the tests expect.
CODES = {code: name for name, code in vars(ua.StatusCodes).items() if name.startswith("Bad")}


@pytest.fixture(scope="module")
def key() -> rsa.RSAPrivateKey:
    """A key that all certificates share: making one takes long."""
    return rsa.generate_private_key(65537, 2048)


def certificate(
    key: rsa.RSAPrivateKey,
    *extensions: x509.ExtensionType,
    uri: str = URI,
    days: tuple[int, int] = (-1, 1),
    issuer: tuple[str, rsa.RSAPrivateKey] | None = None,
    name: str = "hmi",
) -> x509.Certificate:
    """A certificate, valid between these days from now on."""
    authority, signing = issuer or (name, key)
    builder = (
        x509.CertificateBuilder()
        .subject_name(x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, name)]))
        .issuer_name(x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, authority)]))
        .public_key(key.public_key())
        .serial_number(x509.random_serial_number())
        .not_valid_before(NOW + timedelta(days=days[0]))
        .not_valid_after(NOW + timedelta(days=days[1]))
        .add_extension(
            x509.SubjectAlternativeName([x509.UniformResourceIdentifier(uri)]), critical=False
        )
    )
    for extension in extensions:
        builder = builder.add_extension(extension, critical=False)
    return builder.sign(signing, hashes.SHA256())


def der(one: x509.Certificate) -> bytes:
    """Its bytes."""
    return one.public_bytes(Encoding.DER)


def why(one: x509.Certificate | bytes, trusted: Sequence[x509.Certificate] | None = None) -> str:
    """The status with which a certificate is refused; nothing if it is not."""
    content = one if isinstance(one, bytes) else der(one)
    listed = None
    if trusted is not None:
        listed = read_trust_list({str(n): der(found) for n, found in enumerate(trusted)})
    refusal = refusal_of(content, URI, listed)
    return "" if refusal is None else CODES[refusal.status]


SIGNS = x509.KeyUsage(True, False, True, True, False, False, False, False, False)
SIGNS_NOTHING = x509.KeyUsage(False, False, True, True, False, False, False, False, False)
CLIENT = x509.ExtendedKeyUsage([ExtendedKeyUsageOID.CLIENT_AUTH])
SERVER = x509.ExtendedKeyUsage([ExtendedKeyUsageOID.SERVER_AUTH])
AUTHORITY = x509.BasicConstraints(ca=True, path_length=None)


def test_each_step_of_the_check(key: rsa.RSAPrivateKey) -> None:
    """Bytes, key, time, application, use: whatever is trusted."""
    assert why(certificate(key)) == ""
    assert why(certificate(key, SIGNS, CLIENT)) == ""
    assert why(b"") == why(b"\x30\x03\x02\x01\x01") == "BadCertificateInvalid"
    assert why(der(certificate(key)) + b"more") == "BadCertificateInvalid"
    weak = rsa.generate_private_key(65537, 1024)
    assert why(certificate(weak)) == "BadCertificatePolicyCheckFailed"
    assert why(certificate(key, days=(-3, -1))) == "BadCertificateTimeInvalid"
    assert why(certificate(key, days=(1, 3))) == "BadCertificateTimeInvalid"
    assert why(certificate(key, uri="urn:another")) == "BadCertificateUriInvalid"
    assert why(certificate(key, SIGNS_NOTHING)) == "BadCertificateUseNotAllowed"
    assert why(certificate(key, SERVER)) == "BadCertificateUseNotAllowed"


def test_trust(key: rsa.RSAPrivateKey) -> None:
    """Who is listed, and whom a listed authority has issued; nobody who only looks like it."""
    known, other = certificate(key), rsa.generate_private_key(65537, 2048)
    assert why(known, [known]) == ""
    assert why(known, []) == "BadSecurityChecksFailed"
    assert why(certificate(key), [known]) == "BadSecurityChecksFailed"  # the same names and key
    authority = certificate(other, AUTHORITY, name="plant")
    issued = certificate(key, issuer=("plant", other))
    assert why(issued, [authority]) == ""
    assert why(certificate(key, issuer=("plant", key)), [authority]) == "BadSecurityChecksFailed"
    over = certificate(other, AUTHORITY, name="plant", days=(-3, -1))
    assert why(issued, [over]) == "BadSecurityChecksFailed"
    no_authority = certificate(other, name="plant")
    assert why(issued, [no_authority]) == "BadSecurityChecksFailed"
    assert why(certificate(key, days=(-3, -1)), [known]) == "BadSecurityChecksFailed"


def test_revocation(key: rsa.RSAPrivateKey, tmp_path: Path) -> None:
    """A list of revocations counts where the authority has signed it."""
    authority = certificate(key, AUTHORITY, name="plant")
    issued = certificate(key, issuer=("plant", key))
    found = []
    for signing in (key, rsa.generate_private_key(65537, 2048)):
        revoked = (
            x509.CertificateRevocationListBuilder()
            .issuer_name(authority.subject)
            .last_update(NOW)
            .next_update(NOW + timedelta(days=1))
            .add_revoked_certificate(
                x509.RevokedCertificateBuilder()
                .serial_number(issued.serial_number)
                .revocation_date(NOW)
                .build()
            )
            .sign(signing, hashes.SHA256())
        )
        for files in (
            {"a.der": der(authority), "b.crl": revoked.public_bytes(Encoding.DER)},
            {"a": authority.public_bytes(Encoding.PEM), "b": revoked.public_bytes(Encoding.PEM)},
        ):
            refusal = refusal_of(der(issued), URI, read_trust_list(files))
            found.append("" if refusal is None else CODES[refusal.status])
    assert found == ["BadCertificateRevoked"] * 2 + [""] * 2
    (tmp_path / TRUSTED).mkdir()
    (tmp_path / TRUSTED / "note.txt").write_text("no certificate")
    with pytest.raises(Failure) as caught:
        Security(tmp_path)
    assert caught.value.diagnostics[0].id == 901472
    assert "note.txt" in str(caught.value.diagnostics[0])


# --- a server at another address ------------------------------------------------------------------


class Visitor:
    """A client whose certificate, application, channel and user a test chooses."""

    def __init__(self, served: Served, folder: Path, key: rsa.RSAPrivateKey) -> None:
        self.url = served.url.replace("0.0.0.0", "127.0.0.1")
        self._folder = folder
        self._key = folder / "client.pem"
        self._key.write_bytes(key.private_bytes(Encoding.PEM, PrivateFormat.PKCS8, NoEncryption()))
        self.password = (served.folder / "opcua" / PASSWORD).read_text("utf-8").strip()

    async def comes_in(self, one: x509.Certificate, **words: Any) -> str:
        """What becomes of a client: the name of its status, or nothing where it has written."""
        client = patient_client(self.url)
        client.application_uri = words.get("uri", URI)
        file = self._folder / "client.der"
        file.write_bytes(der(one))
        mode = words.get("mode", "SignAndEncrypt")
        if user := words.get("user", "operator"):
            client.set_user(user)
            client.set_password(words.get("password", self.password))
        try:
            await client.set_security_string(f"Basic256Sha256,{mode},{file},{self._key}")
            async with client:
                await client.get_node(OVERRIDE).write_value(100.0)
                return ""
        except ua.UaStatusCodeError as error:
            return CODES.get(error.code, str(error))
        except (TimeoutError, ua.UaError, OSError, ValueError) as error:
            return type(error).__name__

    async def without_encryption(self, *, opens: bool) -> str:
        """The same of a client that does not encrypt, and does not look at what is offered."""
        client = patient_client(self.url)
        await client.connect_socket()
        await client.send_hello()
        try:
            if opens:
                await client.open_secure_channel()
            params = ua.CreateSessionParameters(
                ClientNonce=bytes(32), EndpointUrl=self.url, RequestedSessionTimeout=60_000.0
            )
            await client.uaclient.create_session(params)
        except ua.UaStatusCodeError as error:
            return CODES[error.code]
        except (TimeoutError, ua.UaError, OSError) as error:
            return type(error).__name__
        finally:
            with contextlib.suppress(Exception):
                client.disconnect_socket()
        return ""


@pytest.mark.nightly
@pytest.mark.slow
def test_only_who_is_encrypted_trusted_and_named_comes_in(
    key: rsa.RSAPrivateKey, tmp_path: Path
) -> None:
    """All that is refused is in the log with its reason; then a right client still comes in."""
    served = Served(tmp_path, address="0.0.0.0")
    visitor = Visitor(served, tmp_path, key)
    good = certificate(key, SIGNS, CLIENT)

    async def work() -> None:
        for opens in (True, False):
            assert await visitor.without_encryption(opens=opens) == "BadSecurityModeInsufficient"
        comes_in = visitor.comes_in
        assert await comes_in(good) == ""
        assert await comes_in(good, user="") == "BadIdentityTokenRejected"
        assert await comes_in(good, password="wrong") == "BadUserAccessDenied"
        assert await comes_in(good, user="nobody") == "BadUserAccessDenied"
        assert await comes_in(good, mode="Sign") != ""
        assert await comes_in(good, uri="urn:another") == "BadCertificateUriInvalid"
        late = certificate(key, days=(-3, -1))
        assert await comes_in(late) == "BadCertificateTimeInvalid"
        assert await comes_in(certificate(key, SERVER)) == "BadCertificateUseNotAllowed"
        trusted = tmp_path / "opcua" / TRUSTED
        trusted.mkdir()
        assert await comes_in(good) == "BadSecurityChecksFailed"
        (trusted / "hmi.der").write_bytes(der(good))
        assert await comes_in(good) == ""
        assert await comes_in(certificate(key, SIGNS, CLIENT)) == "BadSecurityChecksFailed"

    try:
        asyncio.run(work())
        reported = " ".join(served.refusals())
        for reason in ("not encrypted", "another application's", "at this time", "another use"):
            assert reason in reported
        assert "not trusted" in reported
    finally:
        served.close()


@pytest.mark.nightly
@pytest.mark.slow
def test_sessions_that_no_user_enters_make_room(tmp_path: Path) -> None:
    """Who begins sessions without a password takes nobody's place for long."""
    served = Served(tmp_path, limits=Limits(sessions=4, entering_s=0.1))
    url = served.url

    async def work() -> None:
        idle = []
        for _ in range(4):
            client = patient_client(url)
            await client.connect_socket()
            await client.send_hello()
            await client.open_secure_channel()
            await client.create_session()
            idle.append(client)
        await asyncio.sleep(0.2)
        async with patient_client(url) as good:
            await good.get_node(OVERRIDE).write_value(100.0)
        for client in idle:
            client.disconnect_socket()

    try:
        asyncio.run(work())
        assert "no user has entered its session, and its place was needed" in served.refusals()
    finally:
        served.close()
