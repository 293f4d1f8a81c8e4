"""The tests of an instrumented build: what each takes and reaches, and which of them fail with a mutant on.

  Test       one GoogleTest, or one run of the program
  Suite      all of them, with the baseline: run once each without a mutant; a campaign for what they miss
  stage_of   how near a test is to a mutated file
"""
import hashlib
import json
import os
import re
import resource
import signal
import subprocess
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass, field
from pathlib import Path

SLOTS = 1 << 20  # as in switches.hpp
VALID = 1
MEMORY = 8 << 30
NOBODY = 65534
STAGES = ("unit", "related", "program", "verify")
RUNS = {"verify": ["verify", "--effort", "quick"], "example": ["example"]}
GRACE = 5.0        # seconds that a run may take beyond a multiple of what it takes without a mutant
SLOWER = 8
PART = 10.0        # seconds after which a campaign is asked what it has found


@dataclass
class Test:
    program: str
    name: str
    file: str = ""
    seconds: float = 0.0
    passed: bool = True
    reached: dict = field(default_factory=dict)   # slot: bits


def stage_of(test, source):
    """unit: the test file mirrors the source file or its folder; related: below the program; program; verify."""
    if test.name in RUNS:
        return "verify"
    folder, stem = Path(source).parts[:-1], Path(source).stem
    file = Path(test.file)
    base = re.sub(r"_test$", "", file.stem)
    mirror = "exact" if folder[0] == "exact" else folder[-1]
    if f"tests/unit/{mirror}/" in test.file or "tests/laws/" in test.file:
        if stem == base or (folder[0] == "exact" and base.startswith(folder[-1])):
            return "unit"
    if re.search(r"tests/(laws|unit/(scalar|algebra|spline|developable|exact|io|fuzz))/|tests/(cross|fuzz)/", test.file):
        return "related"
    return "program"


def wait(process, longest):
    """(exit code, seconds of processor time) of a process and all that it has started; SIGXCPU where it only sleeps."""
    deadline = time.monotonic() + longest
    hung = False
    while True:
        ended, status, usage = os.wait4(process.pid, os.WNOHANG)
        if ended:
            break
        if time.monotonic() > deadline and not hung:
            hung = True
            os.killpg(process.pid, signal.SIGKILL)
        time.sleep(0.005)
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
    process.returncode = os.waitstatus_to_exitcode(status)
    return -signal.SIGXCPU if hung else process.returncode, usage.ru_utime + usage.ru_stime


class Suite:
    def __init__(self, build, jobs):
        self.build, self.jobs = Path(build), jobs
        self.tests = []

    def command(self, tests):
        program = tests[0].program
        if tests[0].name in RUNS:
            return [program, *RUNS[tests[0].name]]
        return [program, "--gtest_filter=" + ":".join(t.name for t in tests), "--gtest_fail_fast", "--gtest_brief=1"]

    def run(self, command, limit, **environment):
        """(exit code, output, seconds of processor time); a negative code is a signal."""
        def limits():
            resource.setrlimit(resource.RLIMIT_CPU, (int(limit) + 1, int(limit) + 2))
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            if os.getuid() == 0:  # a mutant of what writes files could put one in the place of a device
                os.setgroups([])
                os.setgid(NOBODY)
                os.setuid(NOBODY)
        variables = {**os.environ, "RC_PARAMS": "seed=1", **environment}
        with tempfile.TemporaryFile() as out, tempfile.TemporaryDirectory(prefix="torse-mutation-") as scratch:
            variables["TMPDIR"] = scratch
            os.chmod(scratch, 0o777)
            process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=out, env=variables,
                                       start_new_session=True, preexec_fn=limits)
            code, seconds = wait(process, 20 * limit)
            out.seek(0)
            return code, out.read().decode("utf-8", "replace"), seconds

    def programs(self):
        """Test programs with a digest of what they run: their own text and that of the program."""
        found = sorted(self.build.glob("bin/test_*")) + sorted(self.build.glob("test_*"))
        torse = b"".join(p.read_bytes() for p in sorted(self.build.glob("torse*")) if p.is_file())
        return {str(p): hashlib.sha256(p.read_bytes() + torse).hexdigest()
                for p in [*found, self.build / "torse"] if p.is_file()}

    def list_tests(self, program):
        if Path(program).name == "torse":
            return [Test(program, name) for name in RUNS]
        with tempfile.NamedTemporaryFile(suffix=".json") as out:
            subprocess.run([program, "--gtest_list_tests", f"--gtest_output=json:{out.name}"], check=True,
                           stdout=subprocess.DEVNULL)
            report = json.load(open(out.name))
        return [Test(program, f"{suite['name']}.{test['name']}", test["file"])
                for suite in report["testsuites"] for test in suite["testsuite"]]

    def measure(self, test):
        with tempfile.NamedTemporaryFile() as trace:
            os.truncate(trace.name, SLOTS)
            os.chmod(trace.name, 0o666)
            code, _, test.seconds = self.run(self.command([test]), 600, TORSE_MUTANT_TRACE=trace.name)
            test.passed = code == 0
            data = trace.read()
        test.reached = {m.start(): data[m.start()] for m in re.finditer(rb"[^\0]", data)}
        return test

    def baseline(self, store, say):
        """Runs every test of a program that has changed since the stored baseline."""
        old = json.loads(store.read_text()) if store.exists() else {}
        new = {}
        with ThreadPoolExecutor(self.jobs) as pool:
            for program, digest in self.programs().items():
                kept = old.get(program, {})
                if kept.get("digest") == digest:
                    new[program] = kept
                    continue
                tests = self.list_tests(program)
                say(f"measuring {len(tests)} tests of {Path(program).name}")
                new[program] = {"digest": digest, "tests": [asdict(t) for t in pool.map(self.measure, tests)]}
        store.write_text(json.dumps(new))
        self.tests = [Test(**{**t, "reached": {int(k): v for k, v in t["reached"].items()}})
                      for p in new.values() for t in p["tests"]]
        return [t for t in self.tests if not t.passed]

    def passed(self):
        """The slots that some test passes."""
        return {slot for t in self.tests if t.passed for slot in t.reached}

    def reaching(self, slot):
        return [t for t in self.tests if t.passed and slot in t.reached]

    def campaign(self, seconds, mutant=None):
        """What a campaign of so many seconds of one processor finds, the property and its seed; "" for nothing."""
        environment = {} if mutant is None else {"TORSE_MUTANT": str(mutant.slot)}
        with tempfile.TemporaryDirectory(prefix="torse-mutation-") as folder:
            os.chmod(folder, 0o777)
            command = [str(self.build / "torse"), "campaign", "run", "--db", f"{folder}/campaign.db", "--jobs", "1", "--seeds", "1.."]
            spent = 0.0
            while spent < seconds:
                code, out, used = self.run([*command, "--minutes", str(PART / 60)], SLOWER * PART, **environment)
                spent += max(used, PART)
                if code != 0:
                    found = re.search(r"^(?:failed|vacuous): .*", out, re.M)
                    return found.group() if found else f"signal {-code}" if code < 0 else f"exit {code}"
        return ""

    def judge(self, mutant, source):
        """What happens with the mutant on: {"result", "stage", "by", "seconds"}."""
        reaching = self.reaching(mutant.slot)
        tests = [t for t in reaching if t.reached[mutant.slot] & VALID]
        if not tests:
            return {"result": "stillborn" if reaching else "survived", "stage": "", "by": "" if reaching else "not reached",
                    "seconds": 0.0}
        groups = {}
        for test in tests:
            groups.setdefault((STAGES.index(stage_of(test, source)), test.program, test.name in RUNS and test.name),
                              []).append(test)
        order = sorted(groups.items(), key=lambda g: (g[0][0], sum(t.seconds for t in g[1])))
        spent = 0.0
        for (stage, program, _), group in order:
            limit = GRACE + SLOWER * sum(t.seconds for t in group)
            code, out, seconds = self.run(self.command(group), limit, TORSE_MUTANT=str(mutant.slot))
            spent += seconds
            if code != 0:
                failed = re.search(r"\[  FAILED  \] (\S+)", out)
                by = failed.group(1).rstrip(",") if failed else Path(program).name
                hung = code in (-signal.SIGXCPU, -signal.SIGKILL) and not failed
                return {"result": "timeout" if hung else "killed", "stage": STAGES[stage], "seconds": spent,
                        "by": by if failed or hung else f"{by}: " + (f"signal {-code}" if code < 0 else f"exit {code}")}
        return {"result": "survived", "stage": "", "by": f"{len(tests)} tests reach it", "seconds": spent}
