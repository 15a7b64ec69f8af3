# SPDX-License-Identifier: MIT
"""The files by which a CI checks a folder and runs its tests, one for each system."""

from __future__ import annotations

from collections.abc import Mapping

from nctakt.messages.extras import PYTEST

#: The folder in which a wheel of nctakt lies for CI.
WHEELS = "wheels"
#: The installation there, and the command for tests.
INSTALL = f'pip install {WHEELS}/nctakt-*.whl "{PYTEST}"'
#: The Python of CI, and the actions of GitHub.
PYTHON = "3.13"
CHECKOUT, SETUP_PYTHON = "actions/checkout@v5", "actions/setup-python@v6"

_GITHUB = f"""\
# Checks lists and programs and runs the tests. A wheel of nctakt lies in {WHEELS}.
name: nctakt
on: [push, pull_request]
jobs:
  nctakt:
    runs-on: ubuntu-latest
    steps:
      - uses: {CHECKOUT}
      - uses: {SETUP_PYTHON}
        with:
          python-version: "{PYTHON}"
      - run: {INSTALL}
      - run: nctakt check . --format github
      - run: pytest
"""

_GITLAB = f"""\
# Checks lists and programs and runs the tests. A wheel of nctakt lies in {WHEELS}.
nctakt:
  image: python:{PYTHON}
  variables:
    # The runner lets everybody write its files otherwise, and code of a PLC is not run then.
    FF_DISABLE_UMASK_FOR_DOCKER_EXECUTOR: "true"
  script:
    - {INSTALL}
    - nctakt check .
    - pytest --junitxml=report.xml
  artifacts:
    when: always
    reports:
      junit: report.xml
"""

_AZURE = f"""\
# Checks lists and programs and runs the tests. A wheel of nctakt lies in {WHEELS}.
trigger:
  - "*"
pool:
  vmImage: ubuntu-latest
steps:
  - task: UsePythonVersion@0
    inputs:
      versionSpec: "{PYTHON}"
  - script: {INSTALL}
  - script: nctakt check .
  - script: pytest --junitxml=report.xml
  - task: PublishTestResults@2
    condition: always()
    inputs:
      testResultsFiles: report.xml
"""

_JENKINS = f"""\
// Checks lists and programs and runs the tests. A wheel of nctakt lies in {WHEELS}.
pipeline {{
  agent {{ docker {{ image 'python:{PYTHON}' }} }}
  stages {{
    stage('nctakt') {{
      steps {{
        sh 'python -m venv .venv'
        sh '.venv/bin/{INSTALL}'
        sh '.venv/bin/nctakt check .'
        sh '.venv/bin/pytest --junitxml=report.xml'
      }}
    }}
  }}
  post {{ always {{ junit 'report.xml' }} }}
}}
"""

#: For each system the name of its file and the text.
CI_FILES: Mapping[str, tuple[str, str]] = {
    "github": (".github/workflows/nctakt.yml", _GITHUB),
    "gitlab": (".gitlab-ci.yml", _GITLAB),
    "azure": ("azure-pipelines.yml", _AZURE),
    "jenkins": ("Jenkinsfile", _JENKINS),
}
