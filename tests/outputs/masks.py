"""Fields that differ from run to run, by name. Only the value of a field is masked; all around it is compared."""

import re


class Field:
    """A pattern of bytes whose group `value` is no output of the program but of the clock or of chance."""

    def __init__(self, name, pattern):
        self.name = name
        self.pattern = re.compile(pattern)

    def mask(self, data, seen):
        """The bytes with each value replaced by the field's name; `seen` counts them."""
        def replace(match):
            seen[self.name] = seen.get(self.name, 0) + 1
            whole, start = match.group(0), match.start()
            return whole[:match.start("value") - start] + b"<" + self.name.encode() + b">" \
                + whole[match.end("value") - start:]
        return self.pattern.sub(replace, data)


NUMBER = rb"(?P<value>[-+]?[0-9][-+.0-9eE]*)"

TEXT = [
    Field("cpu_s", rb'"cpu_s": *' + NUMBER),
    Field("wall_s", rb'"wall_s": *' + NUMBER),
    Field("step_ms", rb'"step_ms": *' + NUMBER),
    # A moment that has not come is 0, and stays 0.
    Field("created_ms", rb'"created_ms": *(?P<value>[1-9][0-9]*)'),
    Field("updated_ms", rb'"updated_ms": *(?P<value>[1-9][0-9]*)'),
    Field("started_ms", rb'"started_ms": *(?P<value>[1-9][0-9]*)'),
    Field("ended_ms", rb'"ended_ms": *(?P<value>[1-9][0-9]*)'),
    # The report's length goes with the digits of the seconds in it.
    Field("report_bytes", rb'"report\.json": *(?P<value>[0-9]+)'),
    Field("report_bytes", rb'"name": *"report\.json",\s*"size": *(?P<value>[0-9]+)'),
    Field("wall_s", rb"(?P<value>[0-9.]+) s by the clock"),
    Field("cpu_s", rb"(?P<value>[0-9.]+) s of processor time"),
    Field("port", rb"(?:127\.0\.0\.1|localhost|\[::1\]):(?P<value>[0-9]+)"),
]

# Every figure of the service's own statistics; their names and labels stay.
METRICS = [Field("figure", rb"(?m)^(?!#)[^ \n]+ (?P<value>[-+.0-9eE]+)$")]


class Ids:
    """Ids of projects and jobs are made of the time and of chance: the first one seen becomes p_1 or j_1, and so on."""

    PATTERN = re.compile(rb"\b([pj])_[0-9a-hjkmnp-tv-z]{20}\b")

    def __init__(self):
        self.known = {}
        self.counts = {b"p": 0, b"j": 0}

    def mask(self, data, seen):
        def replace(match):
            seen["id"] = seen.get("id", 0) + 1
            found, letter = match.group(0), match.group(1)
            if found not in self.known:
                self.counts[letter] += 1
                self.known[found] = letter + b"_%d" % self.counts[letter]
            return self.known[found]
        return self.PATTERN.sub(replace, data)


def masked(data, masks):
    """The bytes after all masks, and how often each field was met."""
    seen = {}
    for mask in masks:
        data = mask.mask(data, seen)
    return data, seen
