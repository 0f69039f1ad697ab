"""JupyterHub for one server: a class of thirty on two cores and 24 GB. See docs/deploy.md.

    jupyterhub -f deploy/jupyterhub_config.py
"""
import sys

c = get_config()  # noqa: F821 - JupyterHub's own

# ---- Yours to set ----
# Who may log in. PAM, the default, takes the accounts of this machine; OAuthenticator and
# LTIAuthenticator take those of a campus. Without a list nobody gets in.
c.Authenticator.allow_all = False
c.Authenticator.allowed_users = set()
c.Authenticator.admin_users = set()
# The hub listens on this machine only: a web server with a certificate stands in front.
c.JupyterHub.bind_url = "http://127.0.0.1:8000"

# ---- The class ----
c.Spawner.default_url = "/lab"
# All of a class may log in at once; nobody is told to try again later.
c.JupyterHub.concurrent_spawn_limit = 0
c.Spawner.start_timeout = c.Spawner.http_timeout = 300
# One thread for linear algebra: the matrices are 4 by 4, and the cores are shared by all.
# And memory that Python no longer needs goes back to the machine: 2 to 4 MB a kernel.
c.Spawner.environment = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1",
                         "MALLOC_TRIM_THRESHOLD_": "131072"}
# What a student does not need takes memory: no terminals, no language servers.
c.Spawner.args = ["--ServerApp.terminals_enabled=False",
                  "--ServerApp.jpserver_extensions={'jupyter_lsp': False}"]
# Enforced by SystemdSpawner, DockerSpawner and KubeSpawner; see "Limits" in docs/deploy.md.
c.Spawner.mem_limit = "768M"

# ---- Tidying up ----
# Kernels that nobody has used for two hours end, and servers for three.
c.Spawner.args += ["--MappingKernelManager.cull_idle_timeout=7200",
                   "--MappingKernelManager.cull_interval=300"]
c.JupyterHub.services = [{
    "name": "idle-culler",
    "command": [sys.executable, "-m", "jupyterhub_idle_culler", "--timeout=10800"],
}]
c.JupyterHub.load_roles = [{
    "name": "idle-culler",
    "services": ["idle-culler"],
    "scopes": ["list:users", "read:users:activity", "read:servers", "delete:servers"],
}]
