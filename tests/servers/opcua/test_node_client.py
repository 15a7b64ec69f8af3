# SPDX-License-Identifier: MIT
"""A client of another library, node-opcua, reads, writes, calls, acknowledges, and asks the past.

Once without encryption on this computer, once as from elsewhere: encrypted, with a password.
"""

from __future__ import annotations

import asyncio
import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest

pytest.importorskip("asyncua", reason="needs the extra [opcua]")

from asyncua import ua
from support.opcua_client import patient_client
from support.published_model import installed
from support.served import Served

from nctakt.servers.opcua.clients.security import PASSWORD, application_uri

pytestmark = pytest.mark.slow

SCRIPT = Path(__file__).with_name("client.js")


@pytest.fixture(scope="module")
def modules(tmp_path_factory):
    """The folder with node-opcua."""
    if shutil.which("node") is None:
        pytest.skip("node is not installed")
    return installed("node-opcua", tmp_path_factory.mktemp("npm"))


def reported(modules, *words):
    """Return what the client prints."""
    environment = {**os.environ, "NODE_PATH": str(modules)}
    command = ["node", "--security-revert=CVE-2023-46809", str(SCRIPT), *words]
    done = subprocess.run(
        command, env=environment, capture_output=True, text=True, timeout=120, check=False
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout.splitlines()[-1])


def check(found):
    """All that the client has done is as it should be."""
    assert (found["unit"], found["load"], found["write"]) == ("mm", "BadNotSupported", "Good")
    assert found["seen"][-1] == 2.5
    assert (found["reset"], found["start"], found["acknowledge"]) == ("Good",) * 3
    assert (found["alarm"], found["past"]) == ("120002", 50)
    parts = ["Equipment", "Identification", "Messages", "Monitoring", "Notification", "Production"]
    assert [name for name in found["machine"] if name in parts] == parts
    assert found["state"] in (["Initializing", 0], ["Running", 1])
    assert found["feedUnit"] == "%"
    assert found["alert"] == [800, "120002"]


@pytest.mark.nightly
def test_a_client_on_this_computer(modules, tmp_path):
    """Anybody, without encryption."""
    served = Served(tmp_path)
    try:
        served.session.play(1.0)
        check(reported(modules, served.url, str(tmp_path / "wrong.nc")))
    finally:
        served.close()


@pytest.mark.nightly
def test_a_client_from_elsewhere(modules, tmp_path):
    """Only encrypted, and only with the password that the first start has made."""
    served = Served(tmp_path, address="0.0.0.0")
    try:
        served.session.play(1.0)
        password = password_of(tmp_path / "opcua")
        url = served.url.replace("0.0.0.0", "127.0.0.1")
        check(reported(modules, url, str(tmp_path / "wrong.nc"), "operator", password))
    finally:
        served.close()


def test_others_are_refused(tmp_path):
    """No password, a wrong one, no encryption; the files are for their owner alone."""
    served = Served(tmp_path, address="0.0.0.0")
    folder = tmp_path / "opcua"
    url = served.url.replace("0.0.0.0", "127.0.0.1")

    async def refused(user, password, *, encrypts=True):
        client = patient_client(url)
        client.application_uri = application_uri()
        if encrypts:
            certificate, key = folder / "certificate.der", folder / "key.pem"
            await client.set_security_string(f"Basic256Sha256,SignAndEncrypt,{certificate},{key}")
        if user:
            client.set_user(user)
            client.set_password(password)
        try:
            async with client:
                return not await client.get_node("ns=3;s=CncChannelList.1.Id").read_value()
        except (TimeoutError, ua.UaError, OSError, ValueError):
            return True

    async def work():
        password = password_of(folder)
        assert not await refused("operator", password)
        assert await refused("operator", "wrong")
        assert await refused("nobody", password)
        assert await refused("", "")
        assert await refused("operator", password, encrypts=False)
        assert await refused("", "", encrypts=False)

    try:
        asyncio.run(work())
        assert list(served.endpoint.security.failures) == ["127.0.0.1"]
        for file in ("key.pem", "users", PASSWORD):
            assert (folder / file).stat().st_mode & 0o077 == 0
        assert password_of(folder) not in (folder / "users").read_text("utf-8")
    finally:
        served.close()


def password_of(folder):
    """Return the first password."""
    return (folder / PASSWORD).read_text("utf-8").strip()


@pytest.mark.nightly
def test_the_second_start_keeps_certificate_and_users(tmp_path):
    """Clients that trust the server need not do it again."""
    kept = []
    for _ in range(2):
        served = Served(tmp_path, address="0.0.0.0")
        kept.append([(tmp_path / "opcua" / file).read_bytes() for file in ("key.pem", "users")])
        served.close()
    assert kept[0] == kept[1]
