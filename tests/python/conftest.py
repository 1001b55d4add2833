"""What the tests share: a simulated case, and the command line that must find the same."""

import os
import subprocess

import pytest

import angiopose


@pytest.fixture(scope="session")
def cli():
    """Runs angiopose-cli in a folder; 4 (not trustworthy) is an answer too."""

    def run(folder, *arguments):
        done = subprocess.run([os.environ["ANGIOPOSE_CLI"], *arguments], cwd=folder, capture_output=True, text=True)
        assert done.returncode in (0, 4), done.stderr
        return done.stdout

    return run


@pytest.fixture(scope="session")
def demo(tmp_path_factory, cli):
    """A folder with a simulated case: case.angiopose, tree.vtp, angiogram.dcm, true-pose.json."""
    folder = tmp_path_factory.mktemp("demo")
    cli(folder, "simulate", "--seed", "7", "--output", ".")
    return folder


@pytest.fixture(scope="session")
def simulated():
    return angiopose.simulateCase(5, angiopose.SimulationOptions(branchCount=8, frameCount=3))


@pytest.fixture(scope="session")
def arrays(simulated):
    """What registerVessels needs of the simulated case."""
    return angiopose.inputOf(simulated.session)
