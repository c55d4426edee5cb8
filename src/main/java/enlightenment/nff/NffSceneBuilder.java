package enlightenment.nff;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.math.ExactPoint;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Turns entities into the parts of a scene, and notes what gets lost. */
final class NffSceneBuilder {
    private final Scene.Builder scene = Scene.builder();
    private final Notes notes = new Notes();
    private final Map<Material, Material> materials = new HashMap<>();
    private NffFill fill;
    private NffToken fillToken;
    private Material material;
    private boolean hasView;

    NffSceneBuilder(String name) {
        scene.name(name);
    }

    boolean hasView() {
        return hasView;
    }

    void view(NffToken at, NffView view) throws NffSyntaxException {
        Camera camera;
        try {
            camera = view.window();
        } catch (InvalidValueException | ArithmeticException e) {
            throw new NffSyntaxException(
                    at, "expected a view with \"at\" away from \"from\" and \"up\" not along the line of sight");
        }
        if (view.width() != view.height()) {
            notes.add(
                    at,
                    "the angle is taken from top to bottom; pixels are square, so from left to right it is another one");
        }
        scene.camera(camera).size(view.width(), view.height());
        hasView = true;
    }

    void background(DisplayRgb color) {
        Shading.Classic d = Shading.Classic.DEFAULT;
        scene.shading(new Shading.Classic(d.ambient(), d.shadow(), color, d.maxBounces()));
    }

    /** The format does not say how bright a light of colour 1 is, so only its hue has to be kept. */
    void light(NffToken at, ExactPoint position, Vec3 color) {
        double largest = color.maxAbs();
        Vec3 shown = color;
        if (largest > 1) {
            shown = new Vec3(color.x() / largest, color.y() / largest, color.z() / largest);
            notes.add(at, "the light's colour is divided by " + largest + ": no component may exceed 1");
        }
        scene.light(new Light.Point(position, new DisplayRgb(shown.x(), shown.y(), shown.z())));
    }

    void fill(NffToken at, NffFill value) {
        fill = value;
        fillToken = at;
        material = null;
    }

    void sphere(NffToken at, ExactPoint center, double radius) {
        if (radius == 0) {
            notes.add(at, "a sphere of radius 0 is left out");
            return;
        }
        if (radius < 0) {
            noteInside(at);
        }
        add(at, Sphere.of(center, Math.abs(radius)));
    }

    void cone(NffToken at, ExactPoint base, double baseRadius, ExactPoint apex, double apexRadius) {
        double r = Math.abs(baseRadius);
        double top = Math.abs(apexRadius);
        if (r == 0 && top == 0) {
            notes.add(at, "a cone whose radii are 0 is left out");
            return;
        }
        if (baseRadius < 0 || apexRadius < 0) {
            noteInside(at);
        }
        if (r == top) {
            add(at, new Cylinder(base, apex, r, false));
        } else if (r > top) {
            add(at, new Cone(base, apex, r, top, false));
        } else {
            add(at, new Cone(apex, base, top, r, false));
        }
    }

    void polygon(NffToken at, List<ExactPoint> vertices, boolean patch) throws NffSyntaxException {
        if (patch) {
            notes.add(at, "the normals of a patch are not used: it is shown flat");
        }
        Optional<List<Shape>> parts = Polygons.parts(vertices);
        if (parts.isEmpty()) {
            throw new NffSyntaxException(at, "expected a polygon that does not cross itself");
        }
        if (parts.get().isEmpty()) {
            notes.add(at, "a polygon without area is left out");
        }
        for (Shape part : parts.get()) {
            add(at, part);
        }
    }

    private void noteInside(NffToken at) {
        notes.add(at, "a negative radius shows the inside only; here both sides are seen");
    }

    private void add(NffToken at, Shape shape) {
        if (material == null) {
            material = nameMaterial(at);
        }
        scene.object(shape, material);
    }

    /** Equal fills are one material, and fills that nothing uses are none. */
    private Material nameMaterial(NffToken at) {
        if (fill == null) {
            notes.add(at, "no fill (f) comes before this; it is shown white");
        }
        Material made = fill == null ? NffFill.DEFAULT.material(at, notes) : fill.material(fillToken, notes);
        Material known = materials.get(made);
        if (known == null) {
            known = made;
            materials.put(made, made);
            scene.material("fill-" + materials.size(), made);
        }
        return known;
    }

    NffReader.Result build() {
        return new NffReader.Result(scene.build(), notes.list());
    }
}
