"""What a run found, per folder: as text, Markdown and plain data for JSON.

  summary    counts of results and of the stages that killed
  table      in columns      markdown    the same for the documentation      line    one mutant
  unreached  the lines with mutants that no test passes
"""
import datetime
from pathlib import Path

from suite import STAGES

COLUMNS = ("mutants", *STAGES, "timeout", "survived", "equivalent", "stillborn")


def line(row):
    by = f"{row['stage']} {row['by']}".strip()
    campaign = f"; campaign: {row['campaign'] or 'nothing'}" if "campaign" in row else ""
    return f"{row['result']}: {row['id']} [{row['digest']}] {row['before']} -> {row['after']} ({by}{campaign})"


def unreached(mutants, texts):
    """Of (file, mutant): the files, those with most of them first, and their lines with how many are there."""
    lines = {}
    for file, mutant in mutants:
        lines.setdefault(file, []).append(texts[file].count("\n", 0, mutant.at) + 1)
    out = []
    for file, numbers in sorted(lines.items(), key=lambda item: (-len(item[1]), item[0])):
        out.append(f"{file}: {len(numbers)}")
        source = texts[file].splitlines()
        out += [f"  {n} ({numbers.count(n)}): {source[n - 1].strip()}" for n in sorted(set(numbers))]
    return "".join(line + "\n" for line in out)


def count(rows):
    result = {c: 0 for c in COLUMNS}
    for row in rows:
        result["mutants"] += 1
        result[row["stage"] if row["result"] == "killed" else row["result"]] += 1
    killed = sum(result[s] for s in STAGES) + result["timeout"]
    decided = killed + result["survived"]
    result["score"] = round(100 * killed / decided, 1) if decided else None
    return result


def summary(rows, known, left_out, seed, seconds):
    folders = sorted({str(Path(r["file"]).parent) for r in rows})
    return {"date": datetime.datetime.now(datetime.timezone.utc).date().isoformat(), "seed": seed, "seconds": round(seconds),
            "known": known, "left_out": left_out, "total": count(rows),
            "asked": sum("campaign" in r for r in rows), "found": sum(bool(r.get("campaign")) for r in rows),
            "folders": {f: count([r for r in rows if str(Path(r["file"]).parent) == f]) for f in folders}}


def cells(counts):
    score = counts["score"]
    return [str(counts[c]) for c in COLUMNS] + ["-" if score is None else f"{score:.1f}%"]


def rows_of(result):
    return [("folder", [*COLUMNS, "score"])] + [(f, cells(c)) for f, c in result["folders"].items()] + \
        [("all", cells(result["total"]))]


def table(result):
    out = [f"{name:18}" + "".join(f"{c:>11}" for c in row) for name, row in rows_of(result)]
    campaign = f"; a campaign finds {result['found']} of {result['asked']} survivors" if result["asked"] else ""
    return "\n".join(out) + f"\n{result['total']['mutants']} of {result['known']} mutants, seed {result['seed']}, " \
        f"{result['seconds']} s; {result['left_out']} more cannot be switched at run time{campaign}"


def markdown(result):
    lines = ["| " + " | ".join([name, *row]) + " |" for name, row in rows_of(result)]
    lines.insert(1, "|---" + "|---:" * (len(COLUMNS) + 1) + "|")
    return "# Mutation score\n\nWritten by `./x mutate` on " + \
        f"{result['date']}: {result['total']['mutants']} of {result['known']} mutants, seed {result['seed']}, " \
        f"{result['seconds']} s. {result['left_out']} more cannot be switched at run time.\n\n" + "\n".join(lines) + "\n"
