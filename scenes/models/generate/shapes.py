"""scenes/shapes.json, a sculpture of the analytic shapes: python3 scenes/models/generate/shapes.py"""
from files import linear, scene


def write_scene():
    objects = [
        {"name": "floor", "type": "mesh", "mesh": "sweep", "material": "paper"},
        # A plinth of two boxes carries a ring that stands, and a ball of glass in it with a ball of air in its middle.
        {"name": "plinth", "type": "box", "min": [-3.4, 0, -2.2], "max": [3.4, 1.2, 2.2], "material": "slate"},
        {"type": "box", "min": [-3.0, 1.2, -1.8], "max": [3.0, 1.5, 1.8], "material": "brass"},
        {"name": "ring", "type": "torus", "center": [0, 4.9, 0], "axis": [0.22, 0, 1], "majorRadius": 2.9, "minorRadius": 0.5, "material": "gold"},
        {"name": "ball of glass", "type": "sphere", "center": [0, 4.2, 0], "radius": 1.69, "material": "glass"},
        {"name": "ball in the glass", "type": "sphere", "center": [0, 4.2, 0], "radius": 0.8, "material": "amber"},
        # A column, a cone that points down on it, and a disk as a roof.
        {"type": "cylinder", "base": [6.4, 0, 1.5], "top": [6.4, 4.4, 1.5], "radius": 0.75, "material": "terracotta"},
        {"type": "cone", "base": [6.4, 4.4, 1.5], "apex": [6.4, 6.8, 1.5], "radius": 0.5, "topRadius": 1.5, "material": "ivory"},
        {"type": "disk", "center": [6.4, 6.802, 1.5], "normal": [0, 1, 0], "radius": 1.95, "material": "brass"},
        {"type": "sphere", "center": [6.4, 7.812, 1.5], "radius": 1.0, "material": "silver"},
        # A cube on its corner, held by a cone.
        {"type": "cone", "base": [-6.3, 0, 1.2], "apex": [-6.3, 2.1, 1.2], "radius": 1.1, "topRadius": 0.28, "material": "ivory"},
        {"type": "cube", "center": [-6.3, 4.02, 1.2], "radius": 2.0, "rotation": [45, 0, 35.2644], "material": "teal"},
        # Panes behind: two parallelograms and a triangle.
        {"type": "rectangle", "corners": [[-4.6, 0, 5.5], [-3.6, 8.2, 5.5], [-0.6, 8.2, 6.6], [-1.6, 0, 6.6]], "material": "ochre"},
        {"type": "triangle", "vertices": [[0.6, 0, 6.4], [3.1, 9.2, 6.0], [5.6, 0, 5.4]], "material": "rust"},
        # Small things in front.
        {"type": "torus", "center": [3.9, 0.32, -4.0], "axis": [0, 1, 0], "majorRadius": 0.95, "minorRadius": 0.32, "material": "teal"},
        {"type": "sphere", "center": [3.9, 0.86, -4.0], "radius": 0.7, "material": "pearl"},
        {"type": "cylinder", "base": [-3.0, 0.42, -4.4], "top": [-4.9, 0.42, -3.1], "radius": 0.42, "material": "rust"},
        {"type": "cone", "base": [-1.0, 0, -4.9], "apex": [-1.0, 1.25, -4.9], "radius": 0.55, "material": "brass"},
        {"type": "cube", "center": [1.4, 0.42, -5.2], "radius": 0.7275, "rotation": [0, 33, 0], "material": "ivory"},
        {"type": "sphere", "center": [-6.4, 0.55, -2.6], "radius": 0.55, "material": "silver"},
    ]
    scene("shapes", "A sculpture of the analytic shapes: nothing here is made of triangles but the backdrop.\nScript: scenes/models/generate/shapes.py.", {
        "name": "The analytic shapes",
        "image": {"width": 1280, "height": 720},
        "camera": {"type": "perspective", "eye": [-3.5, 7.2, -27], "lookAt": [0.2, 3.9, 0], "fieldOfView": 26},
        "shading": {"model": "physical", "background": linear(0.24, 0.25, 0.27)},
        "display": {"exposure": 0.15, "tone": "filmic"},
        "materials": {
            "paper": {"type": "matte", "color": linear(0.50, 0.46, 0.40)},
            "slate": {"type": "coated", "color": linear(0.06, 0.065, 0.075), "roughness": 0.4},
            "gold": {"type": "glossy", "metal": "gold", "roughness": 0.26},
            "brass": {"type": "glossy", "metal": "brass", "roughness": 0.35},
            "silver": {"type": "glossy", "metal": "silver", "roughness": 0.25},
            "glass": {"type": "glass", "color": "#ffffff", "indexOfRefraction": 1.5},
            "amber": {"type": "glass", "color": "#ffffff", "indexOfRefraction": 1.7, "absorption": [0.05, 0.45, 1.6], "priority": 1},
            "terracotta": {"type": "matte", "color": linear(0.44, 0.18, 0.10), "roughness": 0.4},
            "ivory": {"type": "coated", "color": linear(0.68, 0.62, 0.50), "roughness": 0.35},
            "teal": {"type": "coated", "color": linear(0.03, 0.20, 0.22), "roughness": 0.27},
            "ochre": {"type": "matte", "color": linear(0.62, 0.38, 0.10), "roughness": 0.3},
            "rust": {"type": "coated", "color": linear(0.36, 0.10, 0.05), "roughness": 0.5},
            "pearl": {"type": "coated", "color": linear(0.70, 0.66, 0.62), "roughness": 0.3},
        },
        "meshes": {"sweep": {"file": "models/sweep.ply", "normals": "smooth"}},
        "lights": [
            {"type": "rectangle", "corners": [[-20, 9, -13], [-18, 22, -3], [-5, 22, -9], [-7, 9, -19]], "color": "#fff3e0", "radiance": 6},
            {"type": "rectangle", "corners": [[19, 8, 8], [19, 18, 8], [24, 18, 0], [24, 8, 0]], "color": "#d5e4ff", "radiance": 5},
        ],
        "objects": objects,
        "render": {"method": "raytrace", "antialias": 8},
    })


if __name__ == "__main__":
    write_scene()
