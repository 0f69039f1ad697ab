"""The files for a hub and for Binder: they are read as their readers do, and agree."""
from pathlib import Path

import yaml
from traitlets.config import Config

ROOT = Path(__file__).parent.parent


def hub_config():
    path, config = ROOT / "deploy" / "jupyterhub_config.py", Config()
    exec(compile(path.read_text(), path, "exec"), {"get_config": lambda: config})
    return config


def chart_values():
    return yaml.safe_load((ROOT / "deploy" / "z2jh_values.yaml").read_text())


def test_a_hub_lets_nobody_in_until_told_whom_and_listens_on_this_machine_only():
    config = hub_config()
    assert config.Authenticator.allow_all is False and not config.Authenticator.allowed_users
    assert config.JupyterHub.bind_url.startswith("http://127.0.0.1:")
    assert chart_values()["hub"]["config"]["JupyterHub"]["authenticator_class"] == "null"


def test_one_server_and_a_cluster_give_a_student_the_same():
    spawner, student = hub_config().Spawner, chart_values()["singleuser"]
    assert student["memory"]["limit"] == spawner.mem_limit
    assert student["extraEnv"] == spawner.environment


def test_binder_installs_what_everybody_installs():
    (line,) = (ROOT / "binder" / "requirements.txt").read_text().split("\n")[:1]
    assert (ROOT / "binder" / line.removeprefix("-r ")).resolve() == ROOT / "environment.txt"
    runtime = (ROOT / "binder" / "runtime.txt").read_text().strip()
    assert runtime == "python-3.11"  # Binder's own default is older than kinlab needs
