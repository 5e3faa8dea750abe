# SPDX-License-Identifier: GPL-2.0-or-later
"""Start and stop a host, LIGGGHTS or LAMMPS, on one rank or with MPI; find LIGGGHTS."""

from __future__ import annotations

import os
import select
import shutil
import signal
import subprocess
from collections.abc import Callable, Mapping
from contextlib import closing, suppress
from pathlib import Path
from shlex import join
from time import monotonic

import attrs

from plastigran.engine.log import LOGS, find_error, find_warnings
from plastigran.engine.watch import RunBar

PROJECT = Path(__file__).resolve().parents[3]

#: Time [s] for LIGGGHTS to finish its step and close its files after a request to stop.
GRACE = 10.0
#: Time [s] between checks of the log and the time-out.
INTERVAL = 0.2


class EngineError(RuntimeError):
    """A host is missing or stopped with an error; the message quotes the error of the host."""


class EngineStopped(EngineError):
    """A host started, but ended with an error or was stopped."""


def own_inputs() -> Path:
    """Return the folder `inputs` of the project, or its copy in an installed package."""
    folder = PROJECT / "inputs"
    return folder if folder.is_dir() else Path(__file__).resolve().parents[1] / "inputs"


def inputs_folder() -> Path:
    """Return the folder of the input scripts: $PLASTIGRAN_INPUTS, or `own_inputs()`.

    Raises:
        EngineError: The folder contains no input scripts.
    """
    folder = Path(os.environ.get("PLASTIGRAN_INPUTS", own_inputs())).absolute()
    if not (folder / "collision").is_dir():
        raise EngineError(
            f"the folder {folder} contains no input scripts of plastigran. Set PLASTIGRAN_INPUTS "
            "to their folder"
        )
    return folder


def engine_path() -> Path:
    """Return the path of the program `liggghts-plastigran`, which is LIGGGHTS with the plugin.

    The path is $PLASTIGRAN_ENGINE, the program in the folder `build`, or the first one on PATH.

    Raises:
        EngineError: The program is missing.
    """
    named = os.environ.get("PLASTIGRAN_ENGINE")
    path = Path(named).absolute() if named else PROJECT / "build" / "liggghts-plastigran"
    if os.access(path, os.X_OK):
        return path
    if not named and (installed := shutil.which("liggghts-plastigran")):
        return Path(installed)
    if named or (PROJECT / "run").is_file():
        raise EngineError(
            f"LIGGGHTS is not at {path}. Run `./run setup` to build it, or set PLASTIGRAN_ENGINE "
            "to the path of liggghts-plastigran"
        )
    raise EngineError(
        "LIGGGHTS is missing: liggghts-plastigran is not on PATH. Run `./run setup` in the "
        "project's source tree and set PLASTIGRAN_ENGINE to its build/liggghts-plastigran"
    )


def _liggghts_start(ranks: int) -> list[str]:
    launcher = ["mpirun", "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
    return [*launcher, str(engine_path())]


@attrs.frozen
class Host:
    """A simulation code that runs decks.

    Attributes:
        name: Name for users.
        log: File name of the log.
        start: Function that returns the first words of the command line for a number of MPI ranks.
        environment: Function that returns the environment variables for the host.
        additions: Names of environment variables that a user must set to run the command line in a
            shell.
    """

    name: str
    log: str
    start: Callable[[int], list[str]]
    environment: Callable[[], dict[str, str]]
    additions: tuple[str, ...] = ()


def command(
    deck: str | Path,
    variables: Mapping[str, object],
    folder: Path,
    ranks: int = 1,
    host: Host | None = None,
) -> list[str]:
    """Return the command line that runs a deck with its results in `folder`.

    This function creates a link in `folder` for each path that LIGGGHTS would misread. Variables
    with the value None are omitted.

    Do not add `-screen none`: the mesh reader of LIGGGHTS then writes to a null file and crashes.
    """
    words, links = _command(deck, variables, folder, ranks, host or LIGGGHTS)
    for link, target in links.items():
        link.unlink(missing_ok=True)
        link.symlink_to(target)
    return words


def typed_command(
    deck: str | Path,
    variables: Mapping[str, object],
    folder: Path,
    working_folder: Path,
    ranks: int = 1,
    host: Host | None = None,
) -> str:
    """Return shell commands that do the same as `command` and run the deck.

    The shell commands create the folder of results and the links in it. This function itself
    creates nothing.
    """
    host = host or LIGGGHTS
    words, links = _command(deck, variables, folder, ranks, host)
    if host.additions:
        settings = host.environment()
        words = ["env", *(f"{name}={settings[name]}" for name in host.additions), *words]
    steps = [["mkdir", "-p", folder]]
    steps += [["ln", "-sfn", target, link] for link, target in links.items()]
    steps += [["cd", working_folder]]
    return f"{' && '.join(join(map(str, step)) for step in steps)}\n{join(words)}"


def _command(
    deck: str | Path, variables: Mapping[str, object], folder: Path, ranks: int, host: Host
) -> tuple[list[str], dict[Path, Path]]:
    """Return the words of the command line, and the targets of the links that the run needs."""
    words = [*host.start(ranks), "-in", str(deck), "-log", str(folder / host.log)]
    links = {}
    for name, value in {"inputs": inputs_folder(), "output": folder, **variables}.items():
        if value is None:
            continue
        text = repr(float(value)) if isinstance(value, float) else str(value)
        if misread(text) and Path(text) == folder:
            text = "."
        elif misread(text) and Path(text).is_absolute() and Path(text).exists():
            links[folder / f".{name}"] = Path(text)
            text = f".{name}" if misread(str(folder)) else str(folder / f".{name}")
        words += ["-var", name, text]
    return words, links


def misread(path: str) -> bool:
    """Return whether LIGGGHTS misreads a path.

    LIGGGHTS splits lines at white space. In paths, it replaces * by the step and % by the rank.
    """
    return any(letter.isspace() or letter in "*%" for letter in path)


def environment() -> dict[str, str]:
    """Return the environment for mpirun, with the permission to run as root.

    Open MPI lets waiting ranks yield the processor if there are more ranks than cores. With
    OMPI_MCA_mpi_yield_when_idle=1, waiting ranks always yield the processor. Use this setting on a
    busy machine. On an idle machine, ranks are faster without it.
    """
    permission = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    return (permission if os.geteuid() == 0 else {}) | os.environ


LIGGGHTS = Host("LIGGGHTS", LOGS["liggghts"], _liggghts_start, environment)


def run_deck(
    deck: str | Path,
    variables: Mapping[str, object],
    folder: str | Path,
    ranks: int = 1,
    timeout: float | None = 600.0,
    progress: bool = False,
    working_folder: Path | None = None,
    planned: int = 0,
    meanwhile: Callable[[], None] = lambda: None,
    host: Host = LIGGGHTS,
) -> str:
    """Run a deck to its end.

    The host never runs longer than this function: an error, Ctrl-C or the time-out stops all its
    ranks. The host also stops if Python is killed. The files that it has written are kept.

    Args:
        deck: Path of the input script, absolute or relative to `inputs_folder()`.
        variables: Values for the deck's `variable ... index` settings.
        folder: Folder of the results; created if missing.
        ranks: Number of MPI ranks.
        timeout: Seconds before the run is stopped; None for no limit.
        progress: Whether to show a progress bar, or lines if the output is not a terminal.
        working_folder: Folder in which the host runs, where relative paths of the deck start;
            `folder` if None.
        planned: Total steps of all `run` commands of the deck, for the progress bar; 0 if unknown.
        meanwhile: Function that is called every `INTERVAL` seconds during the run.
        host: Program that runs the deck.

    Returns:
        The log.

    Raises:
        EngineError: The deck or the host is missing.
        EngineStopped: The host ended with an error or took too long. The message quotes the error,
            and the first two and the last of the earlier warnings of contact models.
    """
    folder = Path(folder).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    deck = inputs_folder() / deck
    if not deck.is_file():
        raise EngineError(f"the deck {deck} does not exist")
    words = command(deck, variables, folder, ranks, host)
    # Write the screen output to a file. With a pipe, this process would wait for helper processes
    # of MPI, which may outlive the host. Start the host in a new session, so that only this process
    # receives Ctrl-C from the terminal and then stops the host.
    log, screen = folder / host.log, folder / "screen.txt"
    with (
        open(screen, "w") as output,
        closing(RunBar(deck.stem, log, progress, planned)) as bar,
    ):
        process = subprocess.Popen(
            ["setpriv", "--pdeathsig", "TERM", *words],
            cwd=working_folder or folder,
            env=host.environment(),
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
        try:
            returncode = _wait(process, timeout, bar, meanwhile)
        except subprocess.TimeoutExpired:
            raise EngineStopped(f"{deck.name}: stopped after {timeout:g} s") from None
        finally:
            _stop(process, folder)
    text = log.read_text(errors="replace") if log.exists() else ""
    if returncode:
        complete = text[: text.rfind("\n") + 1]  # LIGGGHTS may have stopped in the middle of a line
        reason = _reason(returncode, complete + screen.read_text(errors="replace"), host.name)
        raise EngineStopped(f"{deck.name}: {reason} (log: {log if text else screen})")
    return text


def engines(folder: Path) -> list[int]:
    """Return the IDs of the processes on this machine that run a host with its log in a folder."""
    logs, numbers = {str(folder / name).encode() for name in LOGS.values()}, []
    for process in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):  # ignore a process that has ended meanwhile
            if logs & set((process / "cmdline").read_bytes().split(b"\0")):
                numbers.append(int(process.name))
    return numbers


def _wait(
    process: subprocess.Popen,
    timeout: float | None,
    bar: RunBar,
    meanwhile: Callable[[], None],
) -> int:
    """Wait until LIGGGHTS ends and return its exit code.

    Raises:
        subprocess.TimeoutExpired: LIGGGHTS has not ended after `timeout` seconds.
    """
    started, ended = monotonic(), select.poll()
    descriptor = os.pidfd_open(process.pid)
    try:
        ended.register(descriptor, select.POLLIN)
        while not ended.poll(1000 * INTERVAL):
            bar.update()
            meanwhile()
            if timeout is not None and monotonic() - started > timeout:
                raise subprocess.TimeoutExpired(process.args, timeout)
    finally:
        os.close(descriptor)
    bar.update()
    return process.wait()


def _stop(process: subprocess.Popen, folder: Path) -> None:
    """Send all ranks a signal to stop, and kill them after `GRACE` seconds."""
    if process.poll() is not None:
        return
    process.terminate()
    try:
        process.wait(GRACE)
    except subprocess.TimeoutExpired:
        pass
    finally:  # also kill the ranks if a second Ctrl-C interrupts the wait
        if process.poll() is None:
            for number in engines(folder):
                with suppress(ProcessLookupError):
                    os.kill(number, signal.SIGKILL)
            process.wait()


def _reason(returncode: int, output: str, host: str) -> str:
    """Return the reason why the host stopped, with earlier warnings, as text.

    The reason follows from the exit code and from the output (log and screen).
    """
    if error := find_error(output):
        # Quote the first two warnings, which often show the cause, and the last warning.
        first, last = find_warnings(output)[:2], find_warnings(output)[2:][-1:]
        return f"{error}; earlier warnings: {'; '.join(first + last)}" if first else error
    # mpirun returns 128 plus the number of the signal.
    number = -returncode if returncode < 0 else returncode - 128
    if number in set(signal.Signals):
        return f"{host} was stopped by the signal {signal.Signals(number).name}"
    return (output.strip().splitlines() or ["no output"])[-1]
