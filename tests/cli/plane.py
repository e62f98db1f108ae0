#!/usr/bin/env python3
"""What plane.sh asks about pictures, piped frames and the terminal: plane.py part | frame | terminal ...
SPDX-License-Identifier: MIT"""
import fcntl, os, pty, re, select, signal, struct, sys, termios, time

ENTERED, LEFT = b"\x1b[?1049h\x1b[?25l", b"\x1b[0m\x1b[?25h\x1b[?1049l"


def read_ppm(path):
    data = open(path, "rb").read()
    head = re.match(rb"P([56])\s+(\d+)\s+(\d+)\s+255\s", data)
    depth = 3 if head[1] == b"6" else 1
    return int(head[2]), int(head[3]), depth, data[head.end():]


def rows_of(path, x, y, width, height):
    """Part of a picture, as rows of bytes."""
    wide, high, depth, data = read_ppm(path)
    assert 0 <= x and 0 <= y and x + width <= wide and y + height <= high, "the part is not in the picture"
    return [data[depth * (wide * row + x):depth * (wide * row + x + width)] for row in range(y, y + height)]


def part(whole, piece, x, y):
    """The piece shows the pixels of the whole picture from (x, y) on."""
    wide, high, _, _ = read_ppm(piece)
    assert rows_of(whole, int(x), int(y), wide, high) == rows_of(piece, 0, 0, wide, high), "the pixels differ"


def pixels_of_line(line):
    """Upper and lower row of one line of half blocks."""
    fore, back, upper, lower = None, None, b"", b""
    for colour, red, green, blue, block in re.findall(r"\x1b\[([34])8;2;(\d+);(\d+);(\d+)m|(\u2580)", line):
        if block:
            upper, lower = upper + fore, lower + back
        elif colour == "3":
            fore = bytes((int(red), int(green), int(blue)))
        else:
            back = bytes((int(red), int(green), int(blue)))
    return [upper, lower]


def frame(frames, lines, number, picture):
    """Frame `number` of piped frames of that many lines shows the picture."""
    text = open(frames, encoding="utf-8").read().split("\n")
    start = (int(number) - 1) * int(lines)
    rows = [row for line in text[start:start + int(lines) - 1] for row in pixels_of_line(line)]
    width, height, _, _ = read_ppm(picture)
    assert rows == rows_of(picture, 0, 0, width, height), "the pixels differ"


class Terminal:
    """A program in a terminal of its own."""

    def __init__(self, columns, rows, command, keyboard=True):
        self.seen = b""
        self.child, self.master = pty.fork()
        if self.child == 0:
            if not keyboard:
                os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
            time.sleep(0.05)  # until the size is set
            os.execv(command[0], command)
        self.resize(columns, rows)
        self.before = termios.tcgetattr(self.master)

    def resize(self, columns, rows):
        fcntl.ioctl(self.master, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))

    def read(self, seconds):
        if not select.select([self.master], [], [], seconds)[0]:
            return False
        try:
            data = os.read(self.master, 65536)
        except OSError:  # the other side is closed
            return False
        self.seen += data
        return bool(data)

    def wait_for(self, what, seconds=20):
        """Reads until the bytes are seen that were not seen before."""
        end, start = time.time() + seconds, len(self.seen)
        while self.seen.find(what, start) < 0:
            assert time.time() < end, f"{what!r} does not come"
            self.read(0.1)

    def press(self, keys):
        os.write(self.master, keys)

    def ends(self, seconds=20):
        """Waits for the end; the exit code, negative for a signal."""
        end = time.time() + seconds
        while True:
            self.read(0.02)
            done, status = os.waitpid(self.child, os.WNOHANG)
            if done:
                while self.read(0):
                    pass
                return os.waitstatus_to_exitcode(status)
            assert time.time() < end, "it does not end"

    def check_restored(self):
        assert self.seen.count(ENTERED) == self.seen.count(LEFT) > 0, "screen or cursor are not given back"
        assert self.seen.endswith(LEFT), "the last word is not the screen's"
        assert termios.tcgetattr(self.master) == self.before, "the keyboard is not as it was"


def ended_by(command, ending, size=(60, 16)):
    t = Terminal(*size, command)
    t.wait_for(b" frame 5 ")
    quiet = termios.tcgetattr(t.master)
    assert not quiet[3] & (termios.ICANON | termios.ECHO), "keys are echoed"
    ending(t)
    code = t.ends()
    assert code == 0, f"exit code {code}"
    t.check_restored()
    return t


def under_a_shell(command):
    """Runs the command as a shell would: suspended, it is told so and goes on."""
    child = os.fork()
    if child == 0:
        os.setpgid(0, 0)
        signal.signal(signal.SIGTTOU, signal.SIG_IGN)
        os.tcsetpgrp(1, os.getpid())
        signal.signal(signal.SIGTTOU, signal.SIG_DFL)
        os.execv(command[0], command)
    status = os.waitpid(child, os.WUNTRACED)[1]
    if os.WIFSTOPPED(status):
        time.sleep(0.2)
        os.write(1, b"suspended")
        time.sleep(0.2)
        os.kill(child, signal.SIGCONT)
        status = os.waitpid(child, 0)[1]
    sys.exit(os.waitstatus_to_exitcode(status))


def suspended(command):
    t = Terminal(60, 16, [sys.executable, os.path.abspath(__file__), "under_a_shell"] + command)
    t.wait_for(b" frame 3 ")
    t.press(b"\x1a")
    t.wait_for(b"suspended")
    seen, t.seen = t.seen, t.seen[:-len(b"suspended")]
    t.check_restored()
    t.seen = seen
    t.wait_for(ENTERED)
    t.wait_for(b" frame ")
    t.press(b"q")
    assert t.ends() == 0
    t.check_restored()


def gone(command):
    """The terminal goes away."""
    t = Terminal(60, 16, command)
    t.wait_for(b" frame 3 ")
    os.close(t.master)
    end = time.time() + 10
    while not os.waitpid(t.child, os.WNOHANG)[0]:
        assert time.time() < end, "it does not end"
        time.sleep(0.05)


def steered(command):
    """Kept to the left, the camera gets far to the left."""
    t = Terminal(100, 12, command)
    for keys in (b"\x1b[D", b"h", b"\x1bOD"):
        t.press(keys)
        t.wait_for(b" frame ")
    t.wait_for(b" at -", 30)
    t.press(b"x\x1b")  # neither means anything
    t.press(b"q")
    assert t.ends() == 0
    t.check_restored()


def terminal(*command):
    command = list(command)
    ended_by(command, lambda t: t.press(b"q"))
    ended_by(command, lambda t: t.press(b"\x03"))
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        ended_by(command, lambda t: os.kill(t.child, number))
    ended_by(command, lambda t: (t.resize(40, 9), t.wait_for(b"\x1b[2J"), t.press(b"q")))
    ended_by(command, lambda t: (t.resize(9, 1), t.wait_for(b"\x1b[2J"), t.press(b"q")))
    ended_by(command + ["--frames", "6"], lambda t: None)
    t = ended_by(command + ["--size", "24x10"], lambda t: t.press(b"Q"))
    line = t.seen.decode("utf-8", "replace").split("\x1b[H")[3].split("\r\n")
    assert len(line) == 6 and line[0].count("\u2580") == 24, "not 24 x 10 pixels"
    suspended(command)
    steered(command)
    gone(command)
    t = Terminal(60, 16, command + ["--frames", "4"], keyboard=False)
    assert t.ends() == 0
    t.check_restored()


TASKS = {"part": part, "frame": frame, "terminal": terminal, "under_a_shell": lambda *words: under_a_shell(list(words))}
if __name__ == "__main__":
    TASKS[sys.argv[1]](*sys.argv[2:])
