package enlightenment.render;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Torus;
import enlightenment.geometry.Transform;
import enlightenment.geometry.Triangle;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import enlightenment.scene.Shading;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import java.util.function.UnaryOperator;

/**
 * The same scene in other coordinates: every position goes through one function, every length through another. Power and intensity
 * grow with areas and absorption falls with lengths, so that all radiance stays; in classic shading, which looks at neither, they stay as
 * they are.
 */
final class MovedScene {
    private final UnaryOperator<BigDecimal> coordinate;
    private final DoubleUnaryOperator length;
    private boolean physical;

    private MovedScene(UnaryOperator<BigDecimal> coordinate, DoubleUnaryOperator length) {
        this.coordinate = coordinate;
        this.length = length;
    }

    /** The scene 2^k times as large: positions and lengths are exact. */
    static Scene scaledByPowerOfTwo(Scene scene, int k) {
        BigDecimal two = BigDecimal.valueOf(2).pow(Math.abs(k));
        // 2^-k = 5^k/10^k has a finite decimal expansion.
        BigDecimal half = BigDecimal.valueOf(5).pow(Math.abs(k)).movePointLeft(Math.abs(k));
        BigDecimal factor = k < 0 ? half : two;
        return new MovedScene(v -> v.multiply(factor), v -> Math.scalb(v, k)).scene(scene);
    }

    /** The scene 10^k times as large: positions are exact, lengths are the nearest doubles of their decimals. */
    static Scene scaledByPowerOfTen(Scene scene, int k) {
        return new MovedScene(
                        v -> v.scaleByPowerOfTen(k),
                        v -> BigDecimal.valueOf(v).scaleByPowerOfTen(k).doubleValue())
                .scene(scene);
    }

    /** The scene elsewhere: t is added to every coordinate, exactly. */
    static Scene translated(Scene scene, BigDecimal t) {
        return new MovedScene(v -> v.add(t), v -> v).scene(scene);
    }

    /** The scene elsewhere, as a program in doubles would put it there: every coordinate becomes the double v + t. */
    static Scene translatedInDoubles(Scene scene, double t) {
        return new MovedScene(v -> new BigDecimal(v.doubleValue() + t), v -> v).scene(scene);
    }

    /** The scene in its place, with every coordinate rounded as it is when t is added to it in doubles. */
    static Scene roundedAsIfAt(Scene scene, double t) {
        return new MovedScene(v -> new BigDecimal(v.doubleValue() + t - t), v -> v).scene(scene);
    }

    /** The scene with every coordinate and length rounded to a multiple of 2^-bits. */
    static Scene rounded(Scene scene, int bits) {
        return new MovedScene(
                        v -> new BigDecimal(Math.scalb(Math.rint(Math.scalb(v.doubleValue(), bits)), -bits)),
                        v -> Math.scalb(Math.rint(Math.scalb(v, bits)), -bits))
                .scene(scene);
    }

    private Scene scene(Scene s) {
        physical = s.shading() instanceof Shading.Physical;
        return new Scene(
                s.name(),
                s.width(),
                s.height(),
                camera(s.camera()),
                s.shading(),
                s.display(),
                s.textures(),
                s.materials(),
                s.lights().stream().map(this::light).toList(),
                s.objects().stream().map(this::object).toList(),
                s.render(),
                s.animation());
    }

    private ExactPoint point(ExactPoint p) {
        return new ExactPoint(coordinate.apply(p.x()), coordinate.apply(p.y()), coordinate.apply(p.z()));
    }

    private double length(double v) {
        return length.applyAsDouble(v);
    }

    private Camera camera(Camera camera) {
        if (camera instanceof Camera.Window w) {
            return new Camera.Window(
                    point(w.eye()),
                    point(w.lowerLeft()),
                    point(w.upperLeft()),
                    point(w.upperRight()),
                    point(w.lowerRight()),
                    length(w.pupilRadius()));
        }
        if (camera instanceof Camera.Perspective p) {
            return new Camera.Perspective(point(p.eye()), point(p.lookAt()), p.up(), p.fieldOfView());
        }
        if (camera instanceof Camera.Orthographic o) {
            return new Camera.Orthographic(point(o.eye()), point(o.lookAt()), o.up(), length(o.height()));
        }
        Camera.Isometric i = (Camera.Isometric) camera;
        return new Camera.Isometric(point(i.lookAt()), length(i.height()));
    }

    private Light light(Light light) {
        if (light instanceof Light.Sphere s) {
            return new Light.Sphere(point(s.center()), length(s.radius()), s.color(), emission(s.emission()));
        }
        if (light instanceof Light.Rectangle r) {
            List<ExactPoint> c = r.anchors().stream().map(this::point).toList();
            return new Light.Rectangle(
                    c.get(0), c.get(1), c.get(2), c.get(3), r.color(), r.twoSided(), emission(r.emission()));
        }
        return new Light.Point(point(((Light.Point) light).position()), light.color(), emission(light.emission()));
    }

    private Emission emission(Emission e) {
        boolean stays = !physical || e.quantity() == Emission.Quantity.RADIANCE;
        double area = length(1) * length(1);
        return stays ? e : new Emission(e.quantity(), times(e.value(), area), e.ultraviolet() * area);
    }

    private static Rgb times(Rgb v, double factor) {
        return new Rgb(v.r() * factor, v.g() * factor, v.b() * factor);
    }

    private SceneObject object(SceneObject o) {
        List<Material> faces = o.faces().stream().map(this::material).toList();
        return new SceneObject(o.name(), shape(o.shape()), material(o.material()), faces);
    }

    private Material material(Material m) {
        boolean absorbs = m instanceof Glass g && g.absorption().max() > 0;
        return absorbs ? ((Glass) m).withAbsorption(absorption(((Glass) m).absorption())) : m;
    }

    private Rgb absorption(Rgb a) {
        return new Rgb(a.r() / length(1), a.g() / length(1), a.b() / length(1));
    }

    /** What coordinates go through as a transform, for meshes; none can round. */
    private Transform transform() {
        double scale = length(1);
        BigDecimal move = coordinate.apply(BigDecimal.ZERO);
        BigDecimal tenth = new BigDecimal("0.1");
        if (scale == 1 && coordinate.apply(tenth).compareTo(tenth.add(move)) != 0) {
            throw new IllegalArgumentException("the coordinates of a mesh cannot be rounded here");
        }
        List<Transform.Step> steps = new ArrayList<>();
        if (scale != 1) {
            steps.add(new Transform.Scale(new Vec3(scale, scale, scale)));
        }
        if (move.signum() != 0) {
            steps.add(new Transform.Translate(new ExactPoint(move, move, move)));
        }
        return Transform.of(steps);
    }

    private Shape shape(Shape shape) {
        if (shape instanceof Sphere s) {
            return new Sphere(point(s.center()), length(s.radius()), s.rotation());
        }
        if (shape instanceof Rectangle r) {
            return new Rectangle(
                    point(r.lowerLeft()), point(r.upperLeft()), point(r.upperRight()), point(r.lowerRight()));
        }
        if (shape instanceof Disk d) {
            return new Disk(point(d.center()), d.normal(), length(d.radius()));
        }
        if (shape instanceof Cylinder c) {
            return new Cylinder(point(c.base()), point(c.top()), length(c.radius()), c.capped());
        }
        if (shape instanceof Cone c) {
            return new Cone(point(c.base()), point(c.apex()), length(c.radius()), length(c.topRadius()), c.capped());
        }
        if (shape instanceof Cube c) {
            return new Cube(point(c.center()), length(c.radius()), c.rotation());
        }
        if (shape instanceof Box b) {
            return new Box(point(b.min()), point(b.max()));
        }
        if (shape instanceof Torus t) {
            return new Torus(point(t.center()), t.axis(), length(t.majorRadius()), length(t.minorRadius()));
        }
        if (shape instanceof Mesh m) {
            return m.placed(transform());
        }
        Triangle t = (Triangle) shape;
        return new Triangle(point(t.a()), point(t.b()), point(t.c()));
    }
}
