# SPDX-License-Identifier: MIT
"""A Dask cluster for studies whose workers are jobs of SLURM, until Enter is pressed.

pip install dask-jobqueue, on the node from which jobs are sent; then

    python examples/studies/slurm.py
    nctakt study examples/studies/stop.toml --scheduler ADDRESS   # in another terminal
"""

from dask_jobqueue import SLURMCluster


def main() -> None:
    """Start the jobs and show the address of the scheduler."""
    cluster = SLURMCluster(cores=32, processes=32, memory="16GB", walltime="04:00:00")
    cluster.scale(jobs=8)  # 256 workers, with one thread each
    print(f"--scheduler {cluster.scheduler_address}")
    input("Enter ends the cluster. ")
    cluster.close()


if __name__ == "__main__":
    main()
