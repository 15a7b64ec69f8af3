# SPDX-License-Identifier: MIT
"""Who may connect: on this computer anybody, from elsewhere only encrypted and with a password.

In: the folder of the server's certificate and users. Out: both, made by the first start; whether a
user's password is right. Passwords are there as scrypt hashes; the first one, which the first start
chooses, also in a file that the reader is to delete.
"""

from __future__ import annotations

import hashlib
import hmac
import ipaddress
import os
import secrets
import socket
import time
from collections import deque
from pathlib import Path
from typing import Any

from asyncua import ua
from cryptography import x509
from cryptography.hazmat.primitives.serialization import Encoding, load_pem_private_key
from cryptography.x509.oid import ExtendedKeyUsageOID

from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.files.output import write_file
from nctakt.messages import diagnostic
from nctakt.messages.connections.opcua import SECURITY_FOLDER_NOT_USABLE
from nctakt.servers.opcua.clients.certificates import TrustList, read_trust_list
from nctakt.servers.opcua.library import User, UserRole, cert_gen

#: The file names in the folder, and that of the folder in it with certificates that are trusted.
CERTIFICATE, KEY, USERS, PASSWORD = "certificate.der", "key.pem", "users", "first-password.txt"
TRUSTED = "trusted"

#: The user that the first start makes.
FIRST_USER = "operator"

#: How long a certificate is valid, in days.
_VALID_DAYS = 3650

#: Files of the trust list that are read.
_MAX_TRUSTED = 1000

#: Cost of a hash: about 10 ms.
_SCRYPT = {"n": 4096, "r": 8, "p": 1}

#: Number of wrong passwords that the clients of one address may try in this many seconds.
MAX_FAILURES, _FAILURE_S = 10, 60.0

#: Addresses whose wrong passwords are remembered; beyond, the one that failed first is forgotten.
_MAX_ADDRESSES = 1000

#: The bits of an address of IPv6 that name a network: whoever has a network has all of its
#: addresses.
_NETWORK_BITS = 64

_PRIVATE = 0o600


def application_uri() -> str:
    """Return the name of this server's application, which its certificate has, too."""
    return f"urn:{socket.gethostname()}:nctakt"


class Security:
    """Certificate and users in a folder; ``made_password``: this start has made the first user."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.made_password = False
        self.failures: dict[str, deque[float]] = {}
        try:
            folder.mkdir(parents=True, exist_ok=True)
            self.key = self._private_key()
            self.certificate = self._own_certificate()
            self._users = self._read_users()
            self._read_trusted()
        except (OSError, ValueError, TypeError) as error:
            found = diagnostic(SECURITY_FOLDER_NOT_USABLE, folder=str(folder), reason=str(error))
            raise Failure(found) from error

    # --- certificate ----------------------------------------------------------------------------

    def _private_key(self) -> Any:
        path = self.folder / KEY
        if not path.exists():
            content = cert_gen.dump_private_key_as_pem(cert_gen.generate_private_key())
            _write_private(path, content)
        return load_pem_private_key(path.read_bytes(), password=None)

    def _own_certificate(self) -> Any:
        path, uri = self.folder / CERTIFICATE, application_uri()
        if path.exists():
            return x509.load_der_x509_certificate(path.read_bytes())
        host = socket.gethostname()
        certificate = cert_gen.generate_self_signed_app_certificate(
            self.key,
            f"nctakt@{host}",
            {"organizationName": "nctakt"},
            [x509.UniformResourceIdentifier(uri), x509.DNSName(host)],
            [ExtendedKeyUsageOID.CLIENT_AUTH, ExtendedKeyUsageOID.SERVER_AUTH],
            _VALID_DAYS,
        )
        write_file(path, certificate.public_bytes(Encoding.DER))
        return certificate

    # --- users ----------------------------------------------------------------------------------

    def _read_users(self) -> dict[str, tuple[bytes, bytes]]:
        path = self.folder / USERS
        if not path.exists():
            password = secrets.token_hex(12)
            salt = secrets.token_bytes(16)
            line = f"{FIRST_USER}:{salt.hex()}:{_hash(password, salt).hex()}\n"
            _write_private(path, line.encode())
            _write_private(self.folder / PASSWORD, f"{password}\n".encode())
            self.made_password = True
        users = {}
        for line in path.read_text(encoding="utf-8").splitlines():
            if line.strip() and not line.startswith("#"):
                name, salt_text, digest = line.split(":")
                users[name] = bytes.fromhex(salt_text), bytes.fromhex(digest)
        return users

    def is_user(self, name: str | None, password: str | None, address: str) -> bool:
        """Return whether a user's password is right; after too many wrong ones none is."""
        now, source = time.monotonic(), _network(address)
        failures = self.failures.get(source, deque())
        while failures and now - failures[0] > _FAILURE_S:
            failures.popleft()
        if len(failures) >= MAX_FAILURES:
            return False
        salt, digest = self._users.get(name or "", (b"", b""))
        is_right = hmac.compare_digest(_hash(password or "", salt or b"none"), digest)
        if not is_right:
            failures.append(now)
            if source not in self.failures and len(self.failures) >= _MAX_ADDRESSES:
                del self.failures[next(iter(self.failures))]
            self.failures[source] = failures
        return is_right

    # --- trust ----------------------------------------------------------------------------------

    def trusted(self) -> TrustList | None:
        """Return whose certificates are trusted, ``None`` if all are: without a folder of them.

        None are while it cannot be read. It is reread for each session: added and removed files
        count at once.
        """
        try:
            return self._read_trusted()
        except (Failure, OSError, ValueError):
            return TrustList((), ())

    def _read_trusted(self) -> TrustList | None:
        folder = self.folder / TRUSTED
        if not folder.is_dir():
            return None
        access = FileAccess([folder])
        files = sorted(folder.iterdir())[:_MAX_TRUSTED]
        return read_trust_list({str(file): access.read_bytes(file) for file in files})

    # --- the library's side ---------------------------------------------------------------------

    def get_user(
        self,
        iserver: Any,
        username: str | None = None,
        password: str | None = None,
        certificate: object = None,
    ) -> User | None:
        """Return the user of a session, ``None`` for a wrong one."""
        if not self.is_user(username, password, iserver.asking):
            return None
        return User(role=UserRole.User, name=username)


class Anybody:
    """Lets anybody in: on this computer."""

    @staticmethod
    def get_user(
        iserver: object,
        username: str | None = None,
        password: str | None = None,
        certificate: object = None,
    ) -> User:
        """Return the user of a session."""
        return User(role=UserRole.User)


#: Means of identification for clients, on this computer and elsewhere.
ANONYMOUS, NAMED = [ua.AnonymousIdentityToken], [ua.UserNameIdentityToken]


def _hash(password: str, salt: bytes) -> bytes:
    return hashlib.scrypt(password.encode(), salt=salt, **_SCRYPT)


def _network(address: str) -> str:
    """Return the key for a client's address: for IPv6 its network, else the address."""
    try:
        found = ipaddress.ip_address(address.partition("%")[0])
    except ValueError:
        return address
    if found.version == 4:
        return str(found)
    if found.ipv4_mapped is not None:
        return str(found.ipv4_mapped)
    return str(ipaddress.ip_network((int(found), _NETWORK_BITS), strict=False))


def _write_private(path: Path, content: bytes) -> None:
    """Write a file that nobody else may read; raises ``OSError``."""
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL
    try:
        with os.fdopen(os.open(path, flags, _PRIVATE), "wb") as file:
            file.write(content)
    except FileExistsError:
        raise
    except BaseException:  # half a key would stop each later start
        path.unlink(missing_ok=True)
        raise
