"""Runs the program on hostile files and measures what they cost it: processor time and peak memory of each command.

usage: measure.py PROGRAM [--only EXPRESSION] [--seconds S] [--mebibytes M]

Prints a table; the last line is a verdict. The exit code is 1 where a command takes more than 10 seconds of processor
time or 1 GiB, ends by a signal or with an unknown exit code, or leaves a temporary file behind.
"""

import argparse
import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile

from files import files


def run(words, most_seconds, most_bytes):
    """Exit code, processor seconds and peak mebibytes of a command with all its child processes."""
    pid = os.fork()
    if pid == 0:
        resource.setrlimit(resource.RLIMIT_CPU, (most_seconds, most_seconds))
        resource.setrlimit(resource.RLIMIT_AS, (most_bytes, most_bytes))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        nowhere = os.open(os.devnull, os.O_RDWR)
        for descriptor in (0, 1, 2):
            os.dup2(nowhere, descriptor)
        os.execv(words[0], words)
    _, status, usage = os.wait4(pid, 0)
    code = os.waitstatus_to_exitcode(status)
    return code, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--only", default="", help="files whose name matches this expression")
    parser.add_argument("--command", default="", help="commands that hold this text")
    parser.add_argument("--seconds", type=float, default=10)
    parser.add_argument("--mebibytes", type=float, default=1024)
    parser.add_argument("--all", action="store_true", help="print every line")
    options = parser.parse_args()
    folder = tempfile.mkdtemp(prefix="torse-hostile-")
    bad = count = 0
    try:
        for name, path, commands in files(folder, options.only):
            for command in commands:
                if options.command not in " ".join(command):
                    continue
                out = os.path.join(folder, "out")
                words = [w.replace("FILE", path).replace("OUT", out) for w in command]
                code, seconds, mebibytes = run([options.program, *words], 60, 4 << 30)
                fine = 0 <= code <= 3 and seconds <= options.seconds and mebibytes <= options.mebibytes
                bad += not fine
                count += 1
                print("%-52s %-28s %3d %7.2f s %7.0f MiB%s" % (name, " ".join(command), code, seconds, mebibytes, "" if fine else "  <--"),
                      flush=True)
    finally:
        shutil.rmtree(folder)
    print("%d commands, %d beyond the limits" % (count, bad))
    return 1 if bad else 0


sys.exit(main())
