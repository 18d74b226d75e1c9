"""The line index finds every key where it stands, whatever TOML lets one write around it."""

from __future__ import annotations

import tomllib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from qcone.design.lines import index_lines

TEXT = '''\
# design = "in a comment"

top = """
[fake.header]
x = 1
"""
path = 'C:\\'
tail = ["""quotes "" inside and one at the end"""", "[", 1]
[a]   # comment
"quoted.key" = 1
'literal key' = 2
b.c . d = 3
list = [ # comment with ] and "
  1, [2, "]"],
  {x = "}"},
]
after = true
inline = {one = 1, two = {three = 3}}
[ a . "x y" ]
z = \'\'\'
y = 1
\'\'\'
w = 0
[[items]]
n = 1
[[items]]
n = 2
'''


@pytest.mark.parametrize(
    ("path", "line"),
    [
        (("top",), 3),
        (("path",), 7),
        (("tail",), 8),
        (("a",), 9),
        (("a", "quoted.key"), 10),
        (("a", "literal key"), 11),
        (("a", "b"), 12),
        (("a", "b", "c", "d"), 12),
        (("a", "list"), 13),
        (("a", "list", 1, 0), 13),
        (("a", "after"), 17),
        (("a", "inline"), 18),
        (("a", "inline", "two", "three"), 18),
        (("a", "x y"), 19),
        (("a", "x y", "z"), 20),
        (("a", "x y", "w"), 23),
        (("items",), 24),
        (("items", 0, "n"), 25),
        (("a", "absent"), 9),
        (("a", "x y", "absent"), 19),
        (("absent",), 1),
        ((), 1),
    ],
)
def test_every_key_is_found_on_its_line(path: tuple[str | int, ...], line: int) -> None:
    tomllib.loads(TEXT)
    assert index_lines(TEXT).line(path) == line


def test_nothing_inside_strings_and_comments_is_taken_for_a_key() -> None:
    index = index_lines(TEXT)
    assert not {("fake",), ("fake", "header"), ("x",), ("design",), ("a", "x y", "y")} & {
        *index.written,
        *index.implied,
    }


def test_an_explicit_header_wins_over_a_longer_one_before_it() -> None:
    index = index_lines("[design.a.imu]\nx = 1\n[design.a]\ny = 2\n")
    assert index.line(("design", "a")) == 3
    assert index.line(("design",)) == 1


KEYS = st.one_of(
    st.from_regex("[A-Za-z0-9_-]{1,6}", fullmatch=True),
    st.text("ab#[]{}.=\"'\\ \n", max_size=6),
)
VALUES = st.recursive(
    st.one_of(st.integers(-99, 99), st.text("ab#[]{}.=,\"'\\\n ", max_size=8)),
    lambda inner: st.one_of(st.lists(inner, max_size=3), st.dictionaries(KEYS, inner, max_size=2)),
    max_leaves=5,
)


def _quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")
    return f'"{escaped}"'


def _multi_line(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"""', '""\\"')
    return f'"""\n{escaped}"""' if not escaped.endswith('"') else _quoted(text)


def _toml(value: object, *, inline: bool = False) -> str:
    if isinstance(value, str):
        return _quoted(value) if inline else _multi_line(value)
    if isinstance(value, list):
        between = ", " if inline else ',\n  # ] comment "\n'
        return f"[{between.join(_toml(each, inline=inline) for each in value)}]"
    if isinstance(value, dict):
        pairs = (f"{_quoted(key)} = {_toml(each, inline=True)}" for key, each in value.items())
        return f"{{{', '.join(pairs)}}}"
    return str(value)


@given(
    st.dictionaries(
        KEYS, st.dictionaries(KEYS, st.tuples(VALUES, st.integers(0, 2)), max_size=4), min_size=1, max_size=3
    )
)
def test_any_file_is_indexed_as_it_was_written(tables: dict[str, dict[str, tuple[object, int]]]) -> None:
    text, expected = "", {}
    for table, values in tables.items():
        expected[(table,)] = text.count("\n") + 1
        text += f"[{_quoted(table)}] # [comment]\n"
        for key, (value, blanks) in values.items():
            text += "\n" * blanks + " # x = 1\n" * blanks
            expected[(table, key)] = text.count("\n") + 1
            text += f"  {_quoted(key)} = {_toml(value)}\n"
    assert tomllib.loads(text) == {
        table: {key: value for key, (value, _) in values.items()} for table, values in tables.items()
    }
    assert dict(index_lines(text).written) == expected
