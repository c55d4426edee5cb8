package enlightenment.device;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Triangle;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;

/**
 * Scenes of any shapes, materials, textures, lights and cameras that devices know. Half of the numbers are multiples of a half, so that faces
 * are parallel to axes, lie in one plane, and touch; the others are anything.
 */
final class RandomClassicScene {
    private final Random random;

    private RandomClassicScene(long seed) {
        random = new Random(seed);
    }

    static Scene of(long seed) {
        return new RandomClassicScene(seed).make();
    }

    private Scene make() {
        Scene.Builder builder = Scene.builder().size(48, 32).camera(camera());
        builder.shading(new Shading.Classic(
                random.nextInt(3) / 4.0, random.nextInt(3) / 3.0, new DisplayRgb(0.1, 0.2, 0.4), random.nextInt(8)));
        int objects = 1 + random.nextInt(random.nextInt(5) == 0 ? 60 : 9);
        for (int k = 0; k < objects; k++) {
            builder.object(shape(), material());
        }
        if (random.nextBoolean()) {
            builder.object(rectangle(at(0, -1.5, 4), new Vec3(0, 0, 6), new Vec3(6, 0, 0)), material());
        }
        for (int k = random.nextInt(3); k >= 0; k--) {
            builder.light(light());
        }
        return builder.build();
    }

    /** A number around 0. */
    private double number(double size) {
        return random.nextBoolean() ? (random.nextInt(5) - 2) * size / 2 : (2 * random.nextDouble() - 1) * size;
    }

    /** A length above 0. */
    private double length() {
        return random.nextBoolean() ? 0.5 * (1 + random.nextInt(2)) : 0.05 + random.nextDouble();
    }

    private static ExactPoint at(double x, double y, double z) {
        return ExactPoint.of(x, y, z);
    }

    private ExactPoint place() {
        return at(number(2), number(1.5), 4 + number(2));
    }

    private Vec3 direction() {
        Vec3 v = new Vec3(number(1), number(1), number(1));
        return v.maxAbs() > 0 ? v : Vec3.Y;
    }

    private Camera camera() {
        return switch (random.nextInt(3)) {
            case 0 -> new Camera.Perspective(at(0.1, 0.2, -2), at(0, 0, 4), Vec3.Y, 40 + random.nextInt(50));
            case 1 -> new Camera.Window(at(0, 0, -3), at(-2, -1, 0), at(-2, 1, 0), at(2, 1, 0), at(2, -1, 0), 0);
            default -> new Camera.Orthographic(at(0.3, 0.1, -2), at(0, 0, 4), Vec3.Y, 4, Camera.Handedness.LEFT);
        };
    }

    private Rectangle rectangle(ExactPoint corner, Vec3 up, Vec3 right) {
        ExactPoint upperLeft = moved(corner, up);
        return new Rectangle(corner, upperLeft, moved(upperLeft, right), moved(corner, right));
    }

    private static ExactPoint moved(ExactPoint p, Vec3 by) {
        Vec3 q = p.toVec3();
        // Sums of multiples of 2^-10 are exact, as those of a parallelogram's corners must be.
        return at(rounded(q.x() + by.x()), rounded(q.y() + by.y()), rounded(q.z() + by.z()));
    }

    private static double rounded(double v) {
        return Math.rint(v * 1024) / 1024;
    }

    private static Vec3 rounded(Vec3 v) {
        return new Vec3(rounded(v.x()), rounded(v.y()), rounded(v.z()));
    }

    private static ExactPoint rounded(ExactPoint p) {
        return moved(p, Vec3.ZERO);
    }

    private Shape shape() {
        ExactPoint p = place();
        double r = length();
        return switch (random.nextInt(8)) {
            case 0 -> new Sphere(p, r, random.nextInt(360));
            case 1 -> {
                Vec3 up = rounded(direction());
                Vec3 right = rounded(across(up));
                yield rectangle(rounded(p), up, right);
            }
            case 2 -> new Triangle(p, moved(p, Vec3.Y), moved(p, across(Vec3.Y)));
            case 3 -> new Disk(p, direction(), r);
            case 4 -> new Box(p, moved(p, new Vec3(rounded(r) + 0.01, length(), length())));
            case 5 -> new Cube(p, r, random.nextBoolean() ? Vec3.ZERO : new Vec3(number(90), number(90), number(90)));
            case 6 -> new Cylinder(p, moved(p, rounded(direction())), r, random.nextBoolean());
            default -> {
                double top = random.nextBoolean() ? 0 : length();
                yield new Cone(p, moved(p, rounded(direction())), r, top, random.nextBoolean());
            }
        };
    }

    private Vec3 across(Vec3 up) {
        Vec3 v = up.cross(direction());
        Vec3 w = v.maxAbs() > 0.01 ? v : up.cross(Math.abs(up.x()) > Math.abs(up.z()) ? Vec3.Z : Vec3.X);
        return rounded(w).maxAbs() > 0 ? w : Vec3.X;
    }

    private DisplayRgb color() {
        return new DisplayRgb(random.nextInt(5) / 4.0, random.nextDouble(), random.nextDouble());
    }

    private Texture texture() {
        return switch (random.nextInt(4)) {
            case 0 -> new Texture.Checker(List.of(color(), color()), 1 + random.nextInt(40) / 4.0);
            case 1 ->
                new Texture.File(
                        Path.of("textures", random.nextBoolean() ? "earth.png" : "fire.png"),
                        random.nextBoolean() ? Texture.Filter.NEAREST : Texture.Filter.BILINEAR,
                        random.nextBoolean() ? Texture.Encoding.SRGB : Texture.Encoding.LINEAR);
            default -> Texture.of(color());
        };
    }

    private Material material() {
        return switch (random.nextInt(5)) {
            case 0 -> Material.Mirror.of(texture());
            case 1 ->
                new Glass(
                        texture(),
                        1 + random.nextInt(4) / 4.0,
                        random.nextBoolean() ? 1 : random.nextDouble(),
                        random.nextInt(3),
                        random.nextBoolean());
            case 2 -> new Material.Matte(texture(), false);
            default -> Material.Matte.of(texture());
        };
    }

    private Light light() {
        ExactPoint p = at(number(1.7), 0.9 + random.nextDouble(), 1.3 + random.nextDouble());
        return switch (random.nextInt(3)) {
            case 0 -> new Light.Point(p, color());
            case 1 -> new Light.Sphere(p, 0.01 + 0.4 * random.nextDouble(), color());
            default -> {
                Rectangle r = rectangle(rounded(p), new Vec3(0, 0, 0.5), new Vec3(0.75, 0.25, 0));
                yield new Light.Rectangle(r.lowerLeft(), r.upperLeft(), r.upperRight(), r.lowerRight(), color());
            }
        };
    }
}
