# SPDX-License-Identifier: MIT
"""The files by which a CI checks a folder and runs its tests, one for each system."""

from __future__ import annotations

from collections.abc import Mapping

_INSTALL = "pip install path/to/nctakt pytest"

_GITHUB = f"""\
# Checks lists and programs and runs the tests. path/to/nctakt: a checkout or a wheel of nctakt.
name: nctakt
on: [push, pull_request]
jobs:
  nctakt:
    runs-on: ubuntu-latest
    steps:
      - uses: actions/checkout@v4
      - uses: actions/setup-python@v5
        with:
          python-version: "3.12"
      - run: {_INSTALL}
      - run: nctakt check . --format github
      - run: pytest
"""

_GITLAB = f"""\
# Checks lists and programs and runs the tests. path/to/nctakt: a checkout or a wheel of nctakt.
nctakt:
  image: python:3.12
  variables:
    # The runner lets everybody write its files otherwise, and code of a PLC is not run then.
    FF_DISABLE_UMASK_FOR_DOCKER_EXECUTOR: "true"
  script:
    - {_INSTALL}
    - nctakt check .
    - pytest --junitxml=report.xml
  artifacts:
    when: always
    reports:
      junit: report.xml
"""

_AZURE = f"""\
# Checks lists and programs and runs the tests. path/to/nctakt: a checkout or a wheel of nctakt.
trigger:
  - "*"
pool:
  vmImage: ubuntu-latest
steps:
  - task: UsePythonVersion@0
    inputs:
      versionSpec: "3.12"
  - script: {_INSTALL}
  - script: nctakt check .
  - script: pytest --junitxml=report.xml
  - task: PublishTestResults@2
    condition: always()
    inputs:
      testResultsFiles: report.xml
"""

_JENKINS = f"""\
// Checks lists and programs and runs the tests. path/to/nctakt: a checkout or a wheel of nctakt.
pipeline {{
  agent {{ docker {{ image 'python:3.12' }} }}
  stages {{
    stage('nctakt') {{
      steps {{
        sh 'python -m venv .venv'
        sh '.venv/bin/{_INSTALL}'
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
