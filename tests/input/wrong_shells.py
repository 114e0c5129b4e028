# SPDX-License-Identifier: Apache-2.0
"""Wrong shells: keys of parts and bodies, laws, contact, solvers, supports."""

ELASTIC = "{model: elastic, density: 7800, young: 2.0e11, poisson: 0.3}"
PLATE = "{plate: {part: skin, size: [1, 1], elements: [2, 2], shell: true}}"
CUBE = "{box: {part: cube, size: [1, 1, 1], elements: [1, 1, 1], at: [0, 0, 0.5]}}"


def cases(wrong):
    """wrong: the type of one case."""
    def shell(what, *says, part="thickness: 0.1", law=ELASTIC, mesh=PLATE, cube=False, more="", lines=1):
        """A plate of shells, with a solid cube above it or without."""
        scene = f"""\
units: SI
mesh: [{mesh}{", " + CUBE if cube else ""}]
materials: {{m: {law}, steel: {ELASTIC}}}
parts:
  skin: {{material: m{", " + part if part else ""}}}
{"  cube: {material: steel}" if cube else ""}
run: {{end: 1.0e-5}}
{more}"""
        return wrong(f"shells {what}", list(says), scene=scene, lines=lines)

    def law(name, text, *says):
        return shell(f"of {name}", "scene.yaml:5: parts.skin.material", *says, "expected elastic, j2", law=text)

    metal = ("model: johnson_cook, density: 8930, young: 1.24e11, poisson: 0.34, A: 9.0e7, B: 2.92e8, n: 0.31, C: 0.025, m: 1.09, melt: 1356, "
             "room: 293, heat_capacity: 383, eos: {model: mie_gruneisen, c: 3940, s: 1.49, gamma: 1.99}")
    box = "{box: {part: skin, size: [1, 1, 1], elements: [1, 1, 1]%s}}"
    return [
        shell("without thickness", "scene.yaml:5: parts.skin: missing thickness", "expected thickness: a length > 0", part=""),
        shell("without thickness by their element", "scene.yaml:5: parts.skin: missing thickness", "expected thickness", part="element: shell4"),
        shell("without thickness by a key", "parts.skin: missing thickness beside points", part="points: 3"),
        shell("of no thickness", "scene.yaml:5: parts.skin.thickness", "out of range: 0", "expected a number > 0", part="thickness: 0"),
        shell("of negative thickness", "parts.skin.thickness", "-1", "> 0", part="thickness: -1"),
        shell("of no points", "parts.skin.points", "1 to 10", part="thickness: 1, points: 0"),
        shell("of eleven points", "parts.skin.points", "1 to 10", part="thickness: 1, points: 11"),
        shell("of one point of Lobatto", "parts.skin.points", "lobatto", "at least 2", part="thickness: 1, points: 1, rule: lobatto"),
        shell("by an unknown rule", "parts.skin.rule", "gauss, lobatto", part="thickness: 1, rule: simpson"),
        shell("beside their middle", "parts.skin.offset", "-0.5 to 0.5", part="thickness: 1, offset: 0.6"),
        shell("on a solid mesh", "parts.skin.thickness: invalid thickness", "solid", mesh=box % ""),
        shell("by element on a solid mesh", "parts.skin.element: invalid element shell4", "hex8_full", part="thickness: 1, element: shell4",
              mesh=box % ""),
        shell("of triangles on a solid mesh", "parts.skin.element: invalid element shell3", part="thickness: 1, element: shell3", mesh=box % ""),
        shell("with a solid element", "parts.skin.element: invalid element hex8_full", "shell4 or shell4_full", part="element: hex8_full"),
        shell("with a thickness of solid elements", "parts.skin.thickness", "invalid for element hex8", part="thickness: 1, element: hex8"),
        shell("with points of solid elements", "parts.skin.points", "invalid for element tet4", part="points: 3, element: tet4", mesh=box % ""),
        law("rubber", "{model: neo_hookean, density: 1100, young: 1.0e6, poisson: 0.45}", "neo_hookean"),
        law("foam", "{model: crushable_foam, density: 200, young: 5.0e7, yield_table: [[0, 1.0e6], [0.6, 1.2e6]]}", "crushable_foam"),
        law("an equation of state", "{" + metal + "}", "eos"),
        law("a fluid", "{model: hydrodynamic, density: 8930, shear: 4.8e10, yield: 1.2e8, eos: {model: mie_gruneisen, c: 3940, s: 1.49, gamma: 1.99}}",
            "hydrodynamic"),
        law("the logarithmic rate", ELASTIC.replace("}", ", stress_rate: logarithmic}"), "stress_rate: logarithmic"),
        shell("in an implicit scene", "scene.yaml:8: solver", "implicit", "expected", more="solver: {scheme: static, step: 1.0e-3}\n"),
        shell("with the thickness in the mesh", "mesh.0.plate.thickness", "expected parts.skin.thickness",
              mesh=PLATE.replace("shell: true", "shell: true, thickness: 0.1")),
        shell("of a plate of three numbers", "mesh.0.plate.elements", "two integers", mesh=PLATE.replace("[2, 2]", "[2, 2, 1]")),
        shell("of a tube of two layers", "mesh.0.tube.elements", "[1, around, along]",
              mesh="{tube: {part: skin, inner_radius: 1, outer_radius: 2, length: 1, elements: [2, 8, 1], shell: true}}"),
        shell("of a tube with a nose", "mesh.0.tube.nose", "without a nose",
              mesh="{tube: {part: skin, inner_radius: 1, outer_radius: 2, length: 1, elements: [1, 8, 1], shell: true, nose: {shape: hemisphere}}}"),
        shell("of a box that is open everywhere", "mesh.0.box.open", "at most five",
              mesh=box % ", shell: true, open: [xmin, xmax, ymin, ymax, zmin, zmax]"),
        shell("of a box that is open nowhere", "mesh.0.box.open", "zmax", mesh=box % ", shell: true, open: [top]"),
        shell("of a solid box with openings", "mesh.0.box.open", "shell: true", part="", mesh=box % ", open: [zmax]"),
        shell("of a cylinder", "mesh.0.cylinder.shell", "unknown key",
              mesh="{cylinder: {part: skin, radius: 1, length: 1, elements: [2, 1], shell: true}}"),
        shell("in contact", "scene.yaml:8: contact.0", "part 'skin' has shells", "between: [a, b]", cube=True, more="contact: [{between: all}]\n"),
        shell("in contact with a solid", "contact.0", "part 'skin' has shells", "expected solid parts", cube=True,
              more="contact: [{between: [cube, skin]}]\n"),
        shell("tied to a solid", "contact.0", "part 'skin' has shells", "ties", cube=True, more="contact: [{between: [cube, skin], tied: true}]\n"),
        shell("with contact of themselves only", "contact.0", "part 'skin' has shells", cube=True,
              more="contact: [{between: all, exclude: [[skin, cube]]}]\n"),
        shell("of two by two points without warping", "parts.skin.warping", "shell4_full", part="thickness: 0.1, element: shell4_full, warping: false"),
        shell("of three corners with hourglass", "parts.skin.hourglass", "shell3", part="thickness: 1, element: shell3, hourglass: {coefficient: 0.1}"),
        shell("that erode by volume", "parts.skin.erosion.volume", "expected damage", part="thickness: 0.1, erosion: {volume: 0.5}"),
        shell("beside solids whose rotations are held", "fixed.0.dofs", "none of its nodes belongs to a shell", cube=True,
              more="fixed: [{part: cube, dofs: [rx]}]\n"),
        shell("beside solids whose rotations are driven", "prescribed.0.dof", "none of its nodes belongs to a shell", cube=True,
              more="prescribed: [{set: cube_zmax, dof: rz, velocity: 1}]\n"),
        shell("beside solids that a moment turns", "forces.0.moment", "none of its nodes belongs to a shell", cube=True,
              more="forces: [{set: cube_zmax, moment: [0, 0, 1]}]\n"),
        shell("whose total has a moment", "forces.0.moment", "invalid together with total",
              more="forces: [{set: skin_xmax, total: [0, 0, 1], moment: [0, 0, 1]}]\n"),
        wrong("rotations held without shells", ["fixed.0.dofs", "nodes without shells"], change=("dofs: [x]", "dofs: [x, rx]")),
        wrong("a moment without shells", ["forces.0.moment", "only nodes of shells rotate"],
              change=("run:", "forces: [{set: foot, moment: [0, 0, 1]}]\nrun:")),
    ]
