"""Who may connect: certificates of ours or of the user, or a warning."""

import ssl
from datetime import UTC, datetime, timedelta
from pathlib import Path

import dask
import pytest
from cryptography import x509

from elastomer_friction.workflow.cluster.security import (
    new_security,
    private_pages,
    security_of,
)
from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.study.cluster import Cluster

THERE = "tls://127.0.0.1:8786"


@pytest.fixture
def files(tmp_path):
    """Return the keys of [cluster] for a certificate and its key, which are in one file."""
    security = new_security(str(tmp_path))
    (name,) = {security.tls_ca_file, security.tls_client_cert, security.tls_client_key}
    return dict.fromkeys(("tls_ca_file", "tls_cert", "tls_key"), name)


def test_no_page_is_served_unless_it_is_asked_for(tmp_path):
    security = new_security(str(tmp_path))
    workers = {"distributed.worker.http.routes": []}
    options = {"dashboard": True, "dashboard_address": "127.0.0.1:0"}
    assert private_pages(security, True) == (workers, options)
    settings, options = private_pages(security, False)
    context = ssl.create_default_context(purpose=ssl.Purpose.CLIENT_AUTH)
    context.load_cert_chain(settings.pop("distributed.scheduler.dashboard.tls.cert"))
    assert settings == workers | {"distributed.scheduler.http.routes": []}
    assert options == {"dashboard": False, "dashboard_address": "127.0.0.1:0"}


def test_only_jobs_have_their_files_quoted_for_a_command_line(tmp_path):
    folder = tmp_path / "a b"
    folder.mkdir()
    for how, expected in (({}, f"{folder}/run.pem"), ({"quoted": True}, f"'{folder}/run.pem'")):
        config = new_security(str(folder), **how).get_tls_config_for_role("worker")
        assert {config["ca_file"], config["cert"], config["key"]} == {expected}


def test_a_clock_that_is_set_back_leaves_our_certificate_valid(files):
    certificate = x509.load_pem_x509_certificate(Path(files["tls_cert"]).read_bytes())
    day = timedelta(days=1)
    assert certificate.not_valid_before_utc < datetime.now(UTC) - day
    assert certificate.not_valid_after_utc > datetime.now(UTC) + 300 * day


def test_certificates_of_the_user_are_used(files, capsys):
    with dask.config.set({"distributed.comm.require-encryption": False}):
        security = security_of(Cluster(THERE, **files))
    assert security.require_encryption
    assert security.get_tls_config_for_role("client")["key"] == files["tls_key"]
    assert capsys.readouterr().err == ""


def test_certificates_of_dask_s_own_configuration_are_used(files):
    with dask.config.set({"distributed.comm.tls.ca-file": files["tls_ca_file"]}):
        assert security_of(Cluster(THERE)).tls_ca_file == files["tls_ca_file"]


def test_without_certificates_a_scheduler_that_asks_for_them_is_refused():
    with pytest.raises(UserError, match=r"needs cluster\.tls_ca_file, cluster\.tls_cert and"):
        security_of(Cluster(THERE))


@pytest.mark.parametrize("name", ["tls_ca_file", "tls_cert", "tls_key"])
def test_certificates_that_cannot_be_read_are_refused_by_name(files, name, tmp_path):
    files[name] = str(tmp_path / "none.pem")
    message = rf"cluster\.{name} = '{files[name]}'.*: cannot be used for TLS: .*No such file"
    with pytest.raises(UserError, match=message):
        security_of(Cluster(THERE, **files))


def test_a_scheduler_that_asks_for_nothing_is_warned_of(capsys):
    assert security_of(Cluster("tcp://127.0.0.1:8786")) is None
    (line,) = capsys.readouterr().err.splitlines()
    assert "neither encrypted nor authenticated: whoever reaches it can run code as you" in line
