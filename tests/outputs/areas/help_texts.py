"""What the program says of itself and of every verb."""

VERBS = ["drape", "check", "serve", "submit", "body", "body make", "body measure", "body presets", "pattern",
         "pattern import", "pattern export", "project", "project new", "project arrange"]


def collect(c):
    c.run("version", "--version")
    c.run("toile", "--help")
    for verb in VERBS:
        c.run(verb, *verb.split(), "--help")
