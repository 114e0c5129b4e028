# SPDX-License-Identifier: Apache-2.0
"""Pictures of a report: the parts at the start and at the end, a field at some times, a film."""
import dataclasses
import io

import numpy as np

from arguments import Fault
from history import grid_of
from pictures import Look, boxes_of, image_of, limits_of, page, take
from report_page import data_uri, el, figure, film, joined, section
from state import field_values

SIZE = (520, 390)        # of a view [pixels]
TIMES = 4                # stills of the field
STATES_OF_A_FILM = 5     # fewer are told by the stills


def picture_uri(image):
    """WebP where Pillow writes it, a fifth of a PNG's size."""
    from PIL import features
    kind = "webp" if features.check("webp") else "png"
    buffer = io.BytesIO()
    image.save(buffer, format=kind.upper(), **({"quality": 88, "method": 4} if kind == "webp" else {}))
    return data_uri(f"image/{kind}", buffer.getvalue())


def panel_figure(panel, history):
    """A curve as a drawing that stays sharp."""
    import matplotlib
    import matplotlib.pyplot as plt
    buffer = io.BytesIO()
    drawing = grid_of([panel], history, 1, 5.4, 3.3)
    with matplotlib.rc_context({"svg.hashsalt": "brunt"}):
        drawing.savefig(buffer, format="svg", metadata={"Date": None, "Creator": None})
    plt.close(drawing)
    return el("img", src=data_uri("image/svg+xml", buffer.getvalue()), alt=f"{panel[0].replace('_', ' ')} over time")


def drawable(state):
    """Records whose places are all finite numbers, and the steps of the others."""
    good, bad = [], []
    for record in state.records:
        finite = np.isfinite(state.positions(record)).all()
        (good if finite else bad).append(record if finite else int(record.attrs["step"]))
    return good, bad


def main_field(records):
    """What most readers look for first among the fields written: the first of them that is not zero at the end."""
    for name in ("plastic_strain", "stress", "contact_pressure", "velocity", "displacement"):
        try:
            values = field_values(records[-1], name)[0]
        except Fault:
            continue
        if np.any(np.isfinite(values) & (np.abs(values) > 1e-12)):
            return name
    return "part"


def evenly(records, count):
    """The first, the last, and what lies between."""
    index = np.unique(np.rint(np.linspace(0, len(records) - 1, min(count, len(records)))).astype(int))
    return [records[k] for k in index]


def parts_pictures(state, records, view):
    """The start and the end, each filling its picture."""
    pieces = []
    for record, deform, words in ((records[0], 0.0, "Undeformed"), (records[-1], 1.0, "Deformed, at the last state")):
        if deform and (len(records) == 1 or "node/displacement" not in record):
            continue
        look = Look(field="part", views=[view], size=SIZE, deform=deform)
        shot = take(state, record, look)
        pieces.append(figure(picture_uri(image_of(page(state, shot, look, (0, 1), boxes_of([shot], look)[0][0]))), words))
    return el("div", *pieces, class_="pair")


def field_pictures(state, records, look, states):
    """Stills, and a film of more states: one range of colours and one frame for all."""
    chosen = evenly(records, states) if states and len(records) >= STATES_OF_A_FILM else []
    stills = evenly(chosen or records, TIMES)
    shots = {record.name: take(state, record, look) for record in {r.name: r for r in [*chosen, *stills]}.values()}
    limits, (boxes, follows) = limits_of(shots.values(), look), boxes_of(shots.values(), look)
    uris = {name: picture_uri(image_of(page(state, shot, look, limits, box))) for (name, shot), box in zip(shots.items(), boxes)}
    times = {name: f"t = {shot.time}" for name, shot in shots.items()}
    title = next(iter(shots.values())).title
    pair = el("div", *(figure(uris[r.name], f"{title}, {times[r.name]}") for r in stills), class_="pair")
    if follows:
        pair = joined([el("p", "The bodies go far, so that the pictures go with them."), pair])
    moving = film([(uris[r.name], times[r.name]) for r in chosen], f"{title} over time") if chosen else None
    return title, pair, moving


def picture_sections(result, look, states):
    """look: view and field of the pictures; an empty field: the main one. A picture that cannot be made leaves a sentence."""
    state = result.state
    records, bad = drawable(state)
    notes = []
    if bad:
        notes.append(f"States with displacements that are no finite numbers are left out: step {', '.join(map(str, bad))}.")
    if not records:
        return [section("pictures", "Pictures", el("p", *notes, " No other state is there to draw."))]
    if "node/displacement" not in records[-1]:
        notes.append("The field displacement was not written, so that all pictures show the undeformed bodies.")
    if len(records) == 1:
        notes.append("There is one state only: the scene's output.every is longer than the run, or the run ended early.")
    asked_for = look.field
    look = dataclasses.replace(look, field=asked_for or main_field(records), size=SIZE)
    sections = []
    try:
        pieces = [parts_pictures(state, records, look.views[0])]
        if look.field != "part":
            if result.get("stopped_by") == "guard" and len(records) > 1:
                records = records[:-1]
                pieces.append(el("p", "What follows leaves out the last state, which the guard refused."))
            title, pair, moving = field_pictures(state, records, look, states)
            pieces += [el("h3", title[0].upper() + title[1:].replace("_", " ")), pair]
            if moving:
                sections.append(section("film", "Film", moving))
    except Fault as fault:
        if asked_for:
            raise
        pieces = [el("p", f"A picture could not be drawn: {fault}.")]
    notes = joined(el("p", note) for note in notes)
    return [section("pictures", "Pictures", notes, *pieces), *sections]
