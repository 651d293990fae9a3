"""Recording as one HTML file, which any browser plays without a server.

The file contains the station's page with its script, style and fonts. It also contains the index and the blocks of the
recording, compressed and in base64. Numbers have only the decimals that pictures and read-outs need. For a long run,
the file contains only every n-th frame, so that its size stays below `LIMIT`.
"""

from __future__ import annotations

import base64
import gzip
import html
import itertools
import math
import re
from collections.abc import Iterator
from pathlib import Path
from typing import cast

import msgspec

from aftdeck.encodable import encodable
from aftdeck.errors import RecordingError
from aftdeck.files import check_new
from aftdeck.report.page.policy import content_policy, hash_source
from aftdeck.station.built import STATIC, built_page
from aftdeck.station.messages.playback import BLOCK
from aftdeck.station.playback.store import PlaybackStore
from aftdeck.station.playback.verdict import verdict
from aftdeck.whole_file import write_new

LIMIT = 4_950_000
"""Largest size of the file [bytes]; most mail servers accept five megabytes."""
DECIMALS = 4
"""Number of decimals of the values in index and blocks, for a resolution of 0.1 mm and 0.006 deg."""
ROUND, ROUND_A_BLOCK = 1000, 60
"""Allowance for the HTML elements around all data, and around each block [bytes]."""

_SCRIPT = re.compile(r'<script type="module"[^>]* src="\./([^"]+)"></script>')
_STYLE = re.compile(r'<link rel="stylesheet"[^>]* href="\./([^"]+)">')
_FONT = re.compile(r"url\(\./([^)]+\.woff2)\)")
_OLD_FONT = re.compile(r',\s*url\(\./[^)]+\.woff\)\s*format\("woff"\)')


def write_html(path: Path, out: Path) -> None:
    """Write a recording as a page that plays it.

    Args:
        path: the recording.
        out: the file to write.

    Raises:
        RecordingError: the recording cannot be read or is too long.
        InputError: the file exists already or cannot be written.
        StationError: the page was not built.
    """
    page = _whole_page(built_page())
    check_new(out)
    with PlaybackStore(path) as store:
        text = _fitting(page, store, path)
    write_new(out, text)


def _fitting(page: str, store: PlaybackStore, path: Path) -> str:
    """Return the text of the file, with as many frames as fit into `LIMIT`."""
    result = verdict(path)
    index = _packed(msgspec.to_builtins(store.index(result)))
    room = LIMIT - len(page.encode()) - len(index) - ROUND
    middle = _packed(msgspec.to_builtins(store.block(store.blocks // 2)))
    stride = max(1, len(middle) * store.blocks // max(room, 1))  # a first guess
    while stride <= store.ticks:
        blocks: list[str] = []
        used = 0
        for block in _blocks(store, stride):
            blocks.append(block)
            used += len(block) + ROUND_A_BLOCK
            if used > room:
                break
        else:
            return _filled(page, path, _packed(msgspec.to_builtins(store.index(result, stride))), blocks)
        done = min(len(blocks) * BLOCK * stride / store.ticks, 1.0)
        stride = max(stride + 1, math.ceil(stride * used / done / max(room, 1)))
    raise RecordingError(f"{path}: does not fit into {LIMIT} bytes")


def _blocks(store: PlaybackStore, stride: int) -> Iterator[str]:
    moments = store.moments(stride)
    while block := tuple(itertools.islice(moments, BLOCK)):
        yield _packed(msgspec.to_builtins(block))


def _packed(value: object) -> str:
    encoded = msgspec.json.encode(_rounded(value))
    return base64.b64encode(gzip.compress(encoded, 9, mtime=0)).decode()


def _rounded(value: object) -> object:
    """Return the value with its numbers rounded to `DECIMALS`, and without negative zeros."""
    if type(value) is float:
        return round(value, DECIMALS) + 0.0
    if type(value) is dict:
        return {name: _rounded(item) for name, item in value.items()}
    if type(value) in (list, tuple):
        return [_rounded(item) for item in cast("list[object]", value)]
    return value


def _filled(page: str, path: Path, index: str, blocks: list[str]) -> str:
    data = [f'<script type="text/plain" id="recording-index">{index}</script>']
    data += [f'<script type="text/plain" id="recording-{i}">{block}</script>' for i, block in enumerate(blocks)]
    titled = page.replace("<title>Aftdeck</title>", f"<title>{html.escape(encodable(path.name))} · Aftdeck</title>", 1)
    head, body = titled.rsplit("</body>", 1)
    return "\n".join([head, *data, f"</body>{body}"])


def _whole_page(page: str) -> str:
    """Return the built page with its script, style and fonts included, so that a browser needs no other file.

    A policy allows only this script and this style, and no request to any other place.
    """
    allowed: dict[str, list[str]] = {"script": [], "style": []}

    def included(kind: str, start: str, text: str) -> str:
        allowed[kind].append(hash_source(text))
        return f"<{start}>{text}</{kind}>"

    notices = f'<script type="text/plain" id="notices">{_notices()}</script>'
    page = page.replace("</body>", f"{notices}\n</body>", 1)
    page = _STYLE.sub(lambda match: included("style", "style", _style(match[1])), page)
    page = _SCRIPT.sub(lambda match: included("script", 'script type="module"', _script(match[1])), page)
    sources = [f"{kind}-src {' '.join(hashes)}" for kind, hashes in allowed.items()]
    policy = content_policy(*sources, "font-src data:")
    return page.replace("<head>", f'<head>\n    <meta http-equiv="Content-Security-Policy" content="{policy}">', 1)


def _script(name: str) -> str:
    text = (STATIC / name).read_text(encoding="utf-8")
    return text.replace("</script", r"<\/script").replace("<!--", r"<\!--")


def _notices() -> str:
    """Return the licences of the packages and fonts in the page, which the file has to contain, too."""
    return (STATIC / "notices.txt").read_text(encoding="utf-8").replace("</script", r"<\/script")


def _style(name: str) -> str:
    folder = (STATIC / name).parent

    def embedded(match: re.Match[str]) -> str:
        return f"url(data:font/woff2;base64,{base64.b64encode((folder / match[1]).read_bytes()).decode()})"

    return _FONT.sub(embedded, _OLD_FONT.sub("", (STATIC / name).read_text(encoding="utf-8")))
