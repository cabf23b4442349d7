"""Prints the benchmarks' ratios as one table."""


def pytest_terminal_summary(terminalreporter, config):
    session = getattr(config, "_benchmarksession", None)
    rows = [
        (bench.name, bench.stats.median * 1000, bench.extra_info.get("units", ""))
        for bench in getattr(session, "benchmarks", [])
        if bench.stats
    ]
    if rows:
        terminalreporter.section("benchmarks in units of one adjacency product")
        for name, milliseconds, units in rows:
            terminalreporter.write_line(f"{name:45s} {milliseconds:10.2f} ms {units:>8} units")
