# SPDX-License-Identifier: Apache-2.0
"""HTML of a report: escaped text, numbers, and the page around them, with its style and the few lines of its film."""
import base64
import html
import json
import math
import os

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "report")


class Html(str):
    """Text that is HTML already; any other text is escaped where it comes into the page."""


def escaped(content):
    return content if isinstance(content, Html) else Html(html.escape(str(content)))


def el(name, /, *content, **attributes):
    """An element. An attribute's name ends in an underscore where Python has the word for itself."""
    words = "".join(f' {key.rstrip("_").replace("_", "-")}="{html.escape(str(value))}"' for key, value in attributes.items())
    if name in ("img", "input", "meta"):
        return Html(f"<{name}{words}>")
    return Html(f"<{name}{words}>{''.join(escaped(piece) for piece in content)}</{name}>")


def joined(pieces):
    return Html("".join(escaped(piece) for piece in pieces))


def number(value, unit="", digits=4):
    """With its unit; what is no finite number says so."""
    if value is None or isinstance(value, str):
        return escaped("unknown" if value is None else value)
    value = value + 0.0 if isinstance(value, float) else value  # no minus zero
    if isinstance(value, float) and not math.isfinite(value):
        return Html("not a finite number")
    behind = escaped(f"\u00a0{unit}" if unit not in ("", "1") else "")
    if isinstance(value, int):
        return Html(f"{value:,}".replace(",", "\u202f").replace("-", "\u2212") + behind)
    mantissa, _, exponent = f"{value:.{digits}g}".partition("e")
    power = f"\u00a0\u00d7\u00a010<sup>{int(exponent)}</sup>" if exponent else ""
    return Html((mantissa + power).replace("-", "\u2212") + behind)


def table(head, rows, **attributes):
    """The first column names its row; numbers stand right."""
    def line(cells, name):
        return el("tr", *(el(name if k else "th", cell, **({"scope": "row"} if not k and name == "td" else {}))
                          for k, cell in enumerate(cells)))
    body = el("tbody", *(line(row, "td") for row in rows))
    top = el("thead", el("tr", *(el("th", cell, scope="col") for cell in head))) if head else Html("")
    return el("div", el("table", top, body, **attributes), class_="scroll")


def data_uri(kind, data):
    return f"data:{kind};base64,{base64.b64encode(data).decode()}"


def figure(uri, words, **attributes):
    return el("figure", el("img", src=uri, alt=words, **attributes), el("figcaption", words))


def section(name, title, *content):
    return el("section", el("h2", title), *content, id=name)


def script_data(value):
    """JSON inside a script element, which nothing in it can end."""
    text = json.dumps(value)
    for sign in "<>&\u2028\u2029":
        text = text.replace(sign, f"\\u{ord(sign):04x}")
    return Html(text)


def film(frames, words):
    """frames: (data URI, text of its time). A slider over the pictures, a button, and keys while it has the focus."""
    uris, times = zip(*frames)
    last = len(frames) - 1
    controls = el("div", el("button", "Play", type="button"),
                  el("input", type="range", min=0, max=last, value=last, step=1, aria_label="time"),
                  el("output", times[-1]), class_="controls")
    hint = el("p", "Space plays and pauses, the arrow keys go from state to state, Home and End to the first and the last.",
              class_="hint")
    data = el("script", script_data({"frames": uris, "times": times}), type="application/json")
    return el("div", el("img", src=uris[-1], alt=words), controls, hint, data, class_="film", tabindex=0)


def page(title, content):
    with open(os.path.join(FOLDER, "style.css"), encoding="utf-8") as stream:
        style = stream.read()
    with open(os.path.join(FOLDER, "film.js"), encoding="utf-8") as stream:
        script = stream.read()
    head = el("head", el("meta", charset="utf-8"), el("meta", name="viewport", content="width=device-width, initial-scale=1"),
              el("title", title), el("style", Html(style)))
    body = el("body", el("main", content), el("script", Html(script)))
    return "<!doctype html>\n" + el("html", head, body, lang="en") + "\n"
