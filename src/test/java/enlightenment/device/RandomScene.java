package enlightenment.device;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
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
import enlightenment.geometry.Transform;
import enlightenment.geometry.Triangle;
import enlightenment.light.Light;
import enlightenment.material.Coated;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.mesh.TriangleMesh;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Random;

/**
 * Scenes of any shapes, materials, textures, lights and cameras that devices know. Half of the numbers are multiples of a half, so that faces
 * are parallel to axes, lie in one plane, and touch; the others are anything.
 */
final class RandomScene {
    private final Random random;

    /** In two scenes of three, so that there are hierarchies of all kinds. */
    private final boolean hasMeshes;

    /** Meshes that there may be instances of. */
    private final List<TriangleMesh> meshes = new ArrayList<>();

    private final boolean isPhysical;

    private RandomScene(long seed, boolean physical) {
        isPhysical = physical;
        random = new Random(seed);
        hasMeshes = random.nextInt(3) > 0;
    }

    static Scene classic(long seed) {
        return new RandomScene(seed, false).make();
    }

    static Scene physical(long seed) {
        return new RandomScene(seed, true).make();
    }

    private Scene make() {
        Scene.Builder builder = Scene.builder().size(48, 32).camera(camera());
        builder.shading(
                isPhysical
                        ? physicalShading()
                        : new Shading.Classic(
                                random.nextInt(3) / 4.0,
                                random.nextInt(3) / 3.0,
                                new DisplayRgb(0.1, 0.2, 0.4),
                                random.nextInt(8)));
        int objects = 1 + random.nextInt(random.nextInt(5) == 0 ? 60 : 9);
        for (int k = 0; k < objects; k++) {
            Shape shape = shape();
            builder.object(shape, isPhysical ? physicalMaterial(shape) : material());
        }
        if (random.nextBoolean()) {
            builder.object(
                    rectangle(at(0, -1.5, 4), new Vec3(0, 0, 6), new Vec3(6, 0, 0)),
                    isPhysical ? opaque() : material());
        }
        for (int k = lightCount(); k > 0; k--) {
            builder.light(light());
        }
        return builder.build();
    }

    private Shading physicalShading() {
        OptionalInt most = random.nextBoolean() ? OptionalInt.empty() : OptionalInt.of(random.nextInt(6));
        return new Shading.Physical(most, random.nextBoolean() ? Rgb.BLACK : new Rgb(0.2, 0.3, 0.1));
    }

    /** In physical shading also so many that one of them is chosen, by its weight or by a tree. */
    private int lightCount() {
        int few = 1 + random.nextInt(3);
        return !isPhysical || random.nextInt(3) > 0 ? few : 4 + random.nextInt(16);
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
            case 0 -> perspective();
            case 1 -> new Camera.Window(at(0, 0, -3), at(-2, -1, 0), at(-2, 1, 0), at(2, 1, 0), at(2, -1, 0), 0);
            default -> new Camera.Orthographic(at(0.3, 0.1, -2), at(0, 0, 4), Vec3.Y, 4, Camera.Handedness.LEFT);
        };
    }

    /** With and without a lens, round and with blades. */
    private Camera perspective() {
        Camera.Perspective camera =
                new Camera.Perspective(at(0.1, 0.2, -2), at(0, 0, 4), Vec3.Y, 40 + random.nextInt(50));
        if (!isPhysical || random.nextBoolean()) {
            return camera;
        }
        int blades = random.nextBoolean() ? 0 : 3 + random.nextInt(6);
        return camera.withLens(new Camera.Lens(0.25 * random.nextDouble(), 2 + random.nextInt(6), blades, 20));
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
        return switch (random.nextInt(hasMeshes ? 10 : 8)) {
            case 8, 9 -> mesh(p, r);
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

    /** A new mesh or one more instance; moved, or turned and stretched. */
    private Shape mesh(ExactPoint at, double size) {
        if (meshes.isEmpty() || random.nextBoolean()) {
            meshes.add(random.nextBoolean() ? wave() : ball());
        }
        TriangleMesh mesh = meshes.get(random.nextInt(meshes.size()));
        Transform.Step move = new Transform.Translate(at);
        if (random.nextBoolean()) {
            return Mesh.of(mesh, Transform.of(move));
        }
        Transform.Step scale = new Transform.Scale(new Vec3(size, length(), random.nextBoolean() ? size : -size));
        Transform.Step turn = new Transform.Rotate(new Vec3(number(90), number(90), number(90)));
        return Mesh.of(mesh, Transform.of(scale, turn, move));
    }

    private TriangleMesh finished(float[] positions, int[] indices, float[] uv) {
        TriangleMesh mesh = TriangleMesh.of(positions, indices).withUv(uv);
        return random.nextBoolean() ? mesh : mesh.smooth(random.nextBoolean() ? 180 : 40);
    }

    /** An open sheet of n × n squares, flat where n is 1. */
    private TriangleMesh wave() {
        int n = 1 + random.nextInt(6);
        float[] p = new float[3 * (n + 1) * (n + 1)];
        float[] uv = new float[2 * (n + 1) * (n + 1)];
        int[] corners = new int[6 * n * n];
        for (int k = 0; k < (n + 1) * (n + 1); k++) {
            int i = k % (n + 1);
            int j = k / (n + 1);
            p[3 * k] = 2f * i / n - 1;
            p[3 * k + 1] = n == 1 || random.nextInt(4) == 0 ? 0 : random.nextFloat() / 2;
            p[3 * k + 2] = 2f * j / n - 1;
            uv[2 * k] = (float) i / n;
            uv[2 * k + 1] = (float) j / n;
        }
        for (int k = 0; k < n * n; k++) {
            int v = k / n * (n + 1) + k % n;
            int[] two = {v, v + n + 1, v + 1, v + 1, v + n + 1, v + n + 2};
            System.arraycopy(two, 0, corners, 6 * k, 6);
        }
        return finished(p, corners, uv);
    }

    /** A closed octahedron, or a ball of rings. */
    private TriangleMesh ball() {
        int rings = 2 + random.nextInt(5);
        int parts = 3 + random.nextInt(5);
        float[] p = new float[3 * ((rings - 1) * parts + 2)];
        float[] uv = new float[p.length / 3 * 2];
        List<Integer> corners = new ArrayList<>();
        int north = (rings - 1) * parts;
        p[3 * north + 1] = 1;
        p[3 * north + 4] = -1;
        for (int r = 1; r < rings; r++) {
            for (int k = 0; k < parts; k++) {
                int v = (r - 1) * parts + k;
                double polar = Math.PI * r / rings;
                double turn = 2 * Math.PI * k / parts;
                p[3 * v] = (float) (Math.sin(polar) * Math.cos(turn));
                p[3 * v + 1] = (float) Math.cos(polar);
                p[3 * v + 2] = (float) (Math.sin(polar) * Math.sin(turn));
                uv[2 * v] = 3f * k / parts;
                uv[2 * v + 1] = (float) r / rings;
                int w = (r - 1) * parts + (k + 1) % parts;
                if (r == 1) {
                    corners.addAll(List.of(north, w, v));
                }
                if (r == rings - 1) {
                    corners.addAll(List.of(north + 1, v, w));
                } else {
                    corners.addAll(List.of(v, w, v + parts, w, w + parts, v + parts));
                }
            }
        }
        return finished(p, corners.stream().mapToInt(i -> i).toArray(), uv);
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

    private Material.Matte opaque() {
        return Material.Matte.of(texture());
    }

    /** Of a shape that may be a light, now and then one that glows. */
    private Material physicalMaterial(Shape shape) {
        if (random.nextInt(6) == 0 && !isOpen(shape)) {
            return glass();
        }
        boolean canGlow =
                shape instanceof Sphere || shape instanceof Rectangle || shape instanceof Box || shape instanceof Cube;
        if (!canGlow || random.nextInt(8) > 0) {
            return random.nextInt(3) == 0 ? opaque() : shiny();
        }
        Rgb radiance = new Rgb(1, 2, 0.5 * random.nextInt(3));
        return opaque().withRadiance(radiance)
                .withPattern(Material.EmissionPattern.of(Optional.empty()).withSide(side()));
    }

    /** Smooth, and by normals of vertices where there are some. */
    private Glass glass() {
        Texture color = random.nextBoolean() ? Texture.of(Rgb.WHITE) : texture();
        Glass glass = new Glass(color, 1.2 + random.nextDouble(), 1, random.nextInt(3), true);
        if (isPhysical && random.nextBoolean()) {
            glass = glass.withAbsorption(new Rgb(0.5 * random.nextInt(3), random.nextDouble(), 0));
        }
        return random.nextBoolean() ? glass : glass.withSmoothRefraction(true);
    }

    /** Whether glass of it would be a pane. */
    private static boolean isOpen(Shape shape) {
        return switch (shape.type()) {
            case "cylinder" -> !((Cylinder) shape).capped();
            case "cone" -> !((Cone) shape).capped();
            case "mesh" -> !((Mesh) shape).triangles().isClosed();
            default -> shape instanceof Rectangle || shape instanceof Triangle || shape instanceof Disk;
        };
    }

    private Material shiny() {
        double roughness = random.nextInt(4) * random.nextDouble() / 4;
        return switch (random.nextInt(4)) {
            case 0 -> opaque().withRoughness(random.nextDouble());
            case 1 -> new Coated(texture(), roughness, 1.2 + random.nextDouble(), random.nextBoolean(), Rgb.BLACK, 0);
            case 2 -> {
                Glossy.Conductor gold = new Glossy.Conductor(new Rgb(0.2, 0.4, 1.3), new Rgb(3.5, 2.5, 1.9));
                Optional<Glossy.Conductor> conductor = random.nextBoolean() ? Optional.of(gold) : Optional.empty();
                yield new Glossy(texture(), roughness, conductor, random.nextBoolean(), Rgb.BLACK);
            }
            default -> Material.Mirror.of(texture());
        };
    }

    private Material.EmissionPattern.Side side() {
        return Material.EmissionPattern.Side.values()[random.nextInt(3)];
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
