package enlightenment.world.check;

import enlightenment.color.DisplayRgb;
import enlightenment.emitter.RectangleEmitter;
import enlightenment.frame.Bounds;
import enlightenment.frame.Rotation;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import enlightenment.world.CompiledScene;
import enlightenment.world.light.ClassicLight;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Predicate;

/**
 * Hints about scenes that are valid but hardly what their author meant: each says what was found and where. A hint is given only where no
 * author could want such a picture, so that a scene that makes sense gets none.
 */
public final class SceneHints {
    /** A smaller angle of view is a mistake, unless some object is seen whole through it. */
    private static final double NARROW_DEGREES = 1;

    /** All hints; each examines the scene and adds its message. */
    private static final List<BiConsumer<SceneHints, List<String>>> ALL = List.of(
            SceneHints::nothingToSee,
            SceneHints::noLight,
            SceneHints::cameraOnSurface,
            SceneHints::cameraInSolid,
            SceneHints::lightInSolid,
            SceneHints::narrowView,
            (hints, found) -> found.addAll(DistanceHint.of(hints.scene, hints.compiled)));

    /** The hints that apply to physical shading, where lights are surfaces and indirect light is solved. */
    private static final List<BiConsumer<SceneHints, List<String>>> OF_PHYSICAL = List.of(
            SceneHints::nothingToSee, SceneHints::cameraOnSurface, SceneHints::narrowView, SceneHints::hiddenLight);

    /** Middle and corners of the picture. */
    private static final List<double[]> PLACES = List.of(new double[][] {{0.5, 0.5}, {0, 0}, {0, 1}, {1, 0}, {1, 1}});

    private final Scene scene;
    private final CompiledScene compiled;

    /** The origins of the rays through the middle and the corners of the picture. */
    private final List<Vec3> starts = new ArrayList<>();

    private SceneHints(Scene scene, CompiledScene compiled) {
        this.scene = scene;
        this.compiled = compiled;
        for (double[] place : PLACES) {
            Ray r = ray(place[0], place[1]);
            starts.add(new Vec3(r.ox, r.oy, r.oz).plus(new Vec3(r.dx, r.dy, r.dz).times(r.tMin)));
        }
    }

    /** The hints for a scene, in plain words; empty for one that makes sense. */
    public static List<String> of(Scene scene, CompiledScene compiled) {
        SceneHints hints = new SceneHints(scene, compiled);
        List<String> found = new ArrayList<>();
        (compiled.classic == null ? OF_PHYSICAL : ALL).forEach(hint -> hint.accept(hints, found));
        // Several primitives of one object may give the same hint.
        return found.stream().distinct().toList();
    }

    private void nothingToSee(List<String> found) {
        if (compiled.primitives.length == 0 && compiled.visibleLights.length == 0) {
            found.add("/objects: there is nothing to see");
        }
    }

    /** Adds hints for lights in exactly the same place as another emitting surface, which alone is seen and emits. */
    private void hiddenLight(List<String> found) {
        boolean[] hasPrimitive = new boolean[compiled.objects];
        for (int id = 0; id < compiled.primitives.length; id++) {
            hasPrimitive[compiled.object[id]] = true;
        }
        // The surfaces of lights come after the objects of the scene.
        int next = scene.objects().size();
        for (int i = 0; i < scene.lights().size(); i++) {
            boolean hasSurface = scene.lights().get(i).hasSurface();
            if (hasSurface && !hasPrimitive[next++]) {
                found.add("/lights/" + i
                        + ": is in exactly the same place as another surface that glows, which is seen in its stead:"
                        + " it gives no light");
            }
        }
    }

    private void noLight(List<String> found) {
        double ambient = compiled.classic.ambient();
        if (ambient == 1 || scene.objects().stream().noneMatch(SceneHints::isShaded)) {
            return;
        }
        if (scene.lights().isEmpty()) {
            found.add("/lights: there is no light; objects show " + ambient
                    + " (/shading/ambient) of their colours, without shading");
        } else if (scene.lights().stream().allMatch(SceneHints::isBlack)) {
            found.add("/lights: every light is black");
        }
    }

    private static boolean isBlack(Light light) {
        DisplayRgb c = light.color().display();
        return c.r() == 0 && c.g() == 0 && c.b() == 0;
    }

    /** Whether an object shows light that falls on it: mirrors and clear glass do not. */
    private static boolean isShaded(SceneObject object) {
        return !materials(object).stream()
                .allMatch(m -> m instanceof Material.Mirror || m instanceof Glass g && g.transparency() == 1);
    }

    private static List<Material> materials(SceneObject object) {
        return object.faces().isEmpty() ? List.of(object.material()) : object.faces();
    }

    /** Adds hints for surfaces that camera rays start on, and therefore hit at once. */
    private void cameraOnSurface(List<String> found) {
        for (int id = 0; id < compiled.primitives.length; id++) {
            Primitive p = compiled.primitives[id];
            if (PLACES.stream().allMatch(place -> isMetAtOnce(p, ray(place[0], place[1])))) {
                found.add("/camera: lies on the surface of " + name(id) + ", which fills the picture");
            }
        }
    }

    private static boolean isMetAtOnce(Primitive p, Ray ray) {
        double t = p.nearest(ray, Double.MAX_VALUE);
        Vec3 start = new Vec3(ray.ox, ray.oy, ray.oz);
        return t != Primitive.MISS
                && (t - ray.tMin) * Math.sqrt(ray.dd)
                        <= Scale.gamma(64) * Math.max(start.maxAbs(), p.bounds().maxAbs());
    }

    /** Adds a hint for a viewer in an opaque solid, who sees its inner wall; without a light inside, it is dark. */
    private void cameraInSolid(List<String> found) {
        if (compiled.classic.ambient() == 1) {
            return;
        }
        for (int id = 0; id < compiled.primitives.length; id++) {
            if (startsIn(compiled.primitives[id]) && isOpaqueSolid(id) && !holdsLight(compiled.primitives[id])) {
                found.add("/camera: is inside " + name(id) + ", which is opaque and holds no light");
            }
        }
    }

    private boolean holdsLight(Primitive solid) {
        for (ClassicLight light : compiled.lights) {
            if (points(light).stream().anyMatch(p -> solid.contains(p.x(), p.y(), p.z()))) {
                return true;
            }
        }
        return false;
    }

    /** Adds hints for lights in an opaque solid: they light nothing visible unless the viewer is inside, too. */
    private void lightInSolid(List<String> found) {
        for (int i = 0; i < compiled.lights.length; i++) {
            ClassicLight light = compiled.lights[i];
            for (int id = 0; id < compiled.primitives.length; id++) {
                Primitive solid = compiled.primitives[id];
                if (isInside(solid, new Vec3(light.ballX, light.ballY, light.ballZ))
                        && isOpaqueSolid(id)
                        && points(light).stream().allMatch(p -> isInside(solid, p))
                        && starts.stream().noneMatch(p -> solid.contains(p.x(), p.y(), p.z()))) {
                    found.add("/lights/" + i + ": is inside " + name(id) + ", which is opaque: no light comes out");
                }
            }
        }
    }

    private boolean isOpaqueSolid(int id) {
        return compiled.primitives[id].isSolid()
                && materials(scene.objects().get(compiled.object[id])).stream()
                        .noneMatch(m -> m instanceof Glass g && g.transparency() > 0);
    }

    private boolean startsIn(Primitive solid) {
        for (Vec3 p : starts) {
            if (!isInside(solid, p)) {
                return false;
            }
        }
        return true;
    }

    private Ray ray(double x, double y) {
        Ray ray = new Ray();
        compiled.camera.ray(x, y, ray);
        return ray;
    }

    /** Whether the point is inside the solid by more than rounding; a point on its surface is not. */
    private static boolean isInside(Primitive solid, Vec3 p) {
        if (!solid.contains(p.x(), p.y(), p.z())) {
            return false;
        }
        double d = Scale.gamma(64) * Math.max(p.maxAbs(), solid.bounds().maxAbs());
        return solid.contains(p.x() - d, p.y(), p.z())
                && solid.contains(p.x() + d, p.y(), p.z())
                && solid.contains(p.x(), p.y() - d, p.z())
                && solid.contains(p.x(), p.y() + d, p.z())
                && solid.contains(p.x(), p.y(), p.z() - d)
                && solid.contains(p.x(), p.y(), p.z() + d);
    }

    /** Points of a light: its centre, and a grid on its surface. */
    private static List<Vec3> points(ClassicLight light) {
        List<Vec3> points = new ArrayList<>();
        Vec3 middle = new Vec3(light.ballX, light.ballY, light.ballZ);
        points.add(middle);
        int steps = light.emitter.isDelta() ? 0 : 4;
        for (int i = -steps; i <= steps; i++) {
            for (int j = -steps; j <= steps; j++) {
                if (light.emitter instanceof RectangleEmitter) {
                    points.add(middle.plus(light.right.times(0.5 * i / steps)).plus(light.up.times(0.5 * j / steps)));
                } else if (steps > 0) {
                    addOnBall(middle, light.radius, i, j, steps, points);
                }
            }
        }
        return points;
    }

    /** Points of a cube's surface, projected onto the ball around its centre. */
    private static void addOnBall(Vec3 middle, double radius, int i, int j, int k, List<Vec3> points) {
        for (int sign = -1; sign <= 1; sign += 2) {
            points.add(middle.plus(new Vec3(i, j, sign * k).normalized().times(radius)));
            points.add(middle.plus(new Vec3(j, sign * k, i).normalized().times(radius)));
            points.add(middle.plus(new Vec3(sign * k, i, j).normalized().times(radius)));
        }
    }

    /** Adds a hint for a very narrow view, usually radians taken for degrees, unless some object is seen whole, as through a telescope. */
    private void narrowView(List<String> found) {
        Ray top = ray(0.5, 0);
        Ray bottom = ray(0.5, 1);
        Vec3 up = new Vec3(top.dx, top.dy, top.dz);
        Vec3 down = new Vec3(bottom.dx, bottom.dy, bottom.dz);
        double sine = up.cross(down).length();
        double cosine = up.dot(down);
        boolean parallel = top.ox != bottom.ox || top.oy != bottom.oy || top.oz != bottom.oz;
        if (parallel || sine * Rotation.cos(NARROW_DEGREES) >= cosine * Rotation.sin(NARROW_DEGREES)) {
            return;
        }
        Predicate<Bounds> seenWhole = seenWhole();
        for (Primitive p : compiled.primitives) {
            if (seenWhole.test(p.bounds())) {
                return;
            }
        }
        for (Bounds light : compiled.lightBounds) {
            if (seenWhole.test(light)) {
                return;
            }
        }
        found.add("/camera: the angle of view is less than 1 degree, and nothing is seen whole through it");
    }

    /** Whether a box lies in the pyramid of the camera's rays. */
    private Predicate<Bounds> seenWhole() {
        Vec3[] corners = new Vec3[4];
        Ray middle = ray(0.5, 0.5);
        Vec3 eye = new Vec3(middle.ox, middle.oy, middle.oz);
        Vec3 forward = new Vec3(middle.dx, middle.dy, middle.dz);
        for (int k = 0; k < 4; k++) {
            Ray r = ray(k == 1 || k == 2 ? 1 : 0, k >> 1);
            corners[k] = new Vec3(r.dx, r.dy, r.dz);
        }
        return box -> {
            for (int k = 0; k < 8; k++) {
                if (!isInPyramid(corners, forward, box.corner(k).minus(eye))) {
                    return false;
                }
            }
            return true;
        };
    }

    private static boolean isInPyramid(Vec3[] corners, Vec3 forward, Vec3 v) {
        for (int k = 0; k < 4; k++) {
            Vec3 wall = corners[k].cross(corners[(k + 1) % 4]);
            if (wall.dot(forward) * wall.dot(v) <= 0) {
                return false;
            }
        }
        return true;
    }

    /** The JSON pointer of an object in the scene file, and its name if it has one. */
    private String name(int id) {
        int index = compiled.object[id];
        String name = scene.objects().get(index).name();
        return "/objects/" + index + (name.isEmpty() ? "" : " (\"" + name + "\")");
    }
}
