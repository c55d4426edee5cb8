package enlightenment.scene.json;

import enlightenment.camera.Camera;
import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
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
import enlightenment.geometry.Torus;
import enlightenment.geometry.Transform;
import enlightenment.geometry.Triangle;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Coated;
import enlightenment.material.Composite;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.material.Principled;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.mesh.MeshFiles;
import enlightenment.scene.Animation;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.ChosenSettings;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import enlightenment.scene.Shading;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.math.BigInteger;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Random;
import java.util.TreeMap;
import java.util.function.Supplier;

/** Scenes of all types with awkward numbers and names. */
final class RandomScenes {
    private static final String[] NAMES = {
        "a", "b/c", "d~e", "f \"g\"", "h\\i", "j\nk", "\u00e4\u00f6", "\ud83c\udf0d", "", "texture 1"
    };

    private final Random random;
    private final Path imageFolder;
    private final Path meshFile;
    private final List<MeshFiles.Part> meshParts;
    private final Map<String, Texture> textures = new LinkedHashMap<>();
    private final Map<String, Material> materials = new LinkedHashMap<>();
    private boolean isPhysical;

    /** Scenes have fluorescent surfaces or glass that disperses light, not both. */
    private boolean hasDyes;

    /** @param folder as {@link Documents#withImage} makes it */
    RandomScenes(long seed, Path folder) {
        this.random = new Random(seed);
        this.imageFolder = folder;
        this.meshFile = folder.resolve("gem.obj");
        try {
            this.meshParts = MeshFiles.read(meshFile, MeshFiles.MAX_TRIANGLES);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    Scene next() {
        textures.clear();
        materials.clear();
        isPhysical = random.nextBoolean();
        hasDyes = random.nextBoolean();
        for (int i = random.nextInt(NAMES.length); i > 0; i--) {
            textures.put(NAMES[i], texture());
        }
        for (int i = random.nextInt(NAMES.length); i > 0; i--) {
            materials.put(NAMES[i], newMaterial());
        }
        Shading shading = shading();
        List<Light> lights = new ArrayList<>();
        for (int i = random.nextInt(6); i > 0; i--) {
            lights.add(retry(this::light));
        }
        List<SceneObject> objects = new ArrayList<>();
        for (int i = random.nextInt(20); i > 0; i--) {
            objects.add(object(random.nextBoolean() ? "" : "object " + i));
        }
        return new Scene(
                NAMES[random.nextInt(NAMES.length)],
                1 + random.nextInt(Scene.MAX_SIDE),
                1 + random.nextInt(Scene.MAX_SIDE),
                camera(shading),
                shading,
                random.nextBoolean()
                        ? Scene.Display.DEFAULT
                        : new Scene.Display(
                                2000 * random.nextDouble() - 1000, DisplayCurve.Tone.values()[random.nextInt(2)]),
                textures,
                materials,
                lights,
                objects,
                random.nextBoolean()
                        ? RenderSettings.Defaults.DEFAULT
                        : new RenderSettings.Defaults(
                                Method.CLUSTER,
                                1 + random.nextInt(256),
                                common(ChosenSettings.of(
                                                new BuiltInMethod.RayTraceSettings(1 + random.nextInt(1_000_000)))
                                        .with(new BuiltInMethod.ClusterSettings(
                                                random.nextBoolean() ? "zeta" : "normal")))),
                random.nextBoolean() ? Optional.empty() : Optional.of(animation(shading, lights, objects)));
    }

    /** With any values of the settings that all methods have. */
    private ChosenSettings common(ChosenSettings chosen) {
        ChosenSettings all = chosen;
        for (Method.Setting setting : ChosenSettings.Common.ALL) {
            if (setting instanceof Method.Setting.Whole w) {
                all = all.with(w, Math.max(w.min(), Math.min(w.max(), random.nextLong() >> random.nextInt(64))));
            } else if (setting instanceof Method.Setting.Word w) {
                all = all.with(w, w.words().get(random.nextInt(w.words().size())));
            }
        }
        return all;
    }

    private Shading shading() {
        if (!isPhysical) {
            return random.nextBoolean()
                    ? Shading.Classic.DEFAULT
                    : new Shading.Classic(unit(), unit(), color(), random.nextInt(1000));
        }
        return random.nextInt(3) == 0
                ? Shading.Physical.DEFAULT
                : new Shading.Physical(
                        random.nextBoolean() ? OptionalInt.empty() : OptionalInt.of(random.nextInt(1000)),
                        background(),
                        random.nextBoolean() ? Optional.empty() : Optional.of(retry(this::medium)));
    }

    private Shading.Background background() {
        switch (random.nextInt(3)) {
            case 0:
                return new Shading.Background.Constant(
                        new Rgb(1e9 * unit(), random.nextDouble(), random.nextDouble() * 1e-9));
            case 1:
                List<Texture.File> named = textures.values().stream()
                        .filter(Texture.File.class::isInstance)
                        .map(Texture.File.class::cast)
                        .toList();
                Texture.File picture = named.isEmpty() ? file() : named.get(random.nextInt(named.size()));
                if (named.isEmpty()) {
                    textures.put("around", picture);
                }
                return new Shading.Background.Picture(
                        picture, random.nextBoolean() ? Rgb.WHITE : radiance(), random.nextBoolean() ? 0 : number());
            default:
                return new Shading.Background.Sky(
                        90 * unit(),
                        random.nextBoolean() ? 0 : number(),
                        random.nextBoolean() ? Shading.Background.Sky.USUAL_TURBIDITY : 2 + 8 * random.nextDouble(),
                        random.nextBoolean() ? Rgb.BLACK : new Rgb(unit(), unit(), unit()),
                        random.nextBoolean() ? Rgb.WHITE : radiance(),
                        random.nextBoolean());
        }
    }

    private Medium medium() {
        double anisotropy = random.nextBoolean() ? 0 : 2 * unit() - 1;
        return random.nextBoolean()
                ? new Medium.Colored(surfaceColor(), new Rgb(positive(), positive(), positive()), anisotropy)
                : new Medium.Coefficients(radiance(), radiance(), anisotropy);
    }

    /** Some random values make no shape: then others do. */
    private static <T> T retry(Supplier<T> maker) {
        while (true) {
            try {
                return maker.get();
            } catch (IllegalArgumentException e) {
                // Degenerate; the next one.
            }
        }
    }

    private Animation animation(Shading shading, List<Light> lights, List<SceneObject> objects) {
        List<Animation.Track> tracks = new ArrayList<>();
        tracks.add(new Animation.Track("/shading/background/" + animated(shading), keys()));
        tracks.add(new Animation.Track("/render/seed", keys()));
        if (random.nextBoolean()) {
            tracks.add(new Animation.Track("/display/exposure", keys()));
        }
        for (int i = 0; i < lights.size(); i++) {
            tracks.add(track("/lights/" + i + "/", lights.get(i).emission()));
        }
        for (int i = 0; i < objects.size(); i++) {
            SceneObject o = objects.get(i);
            if (o.shape() instanceof Sphere) {
                tracks.add(new Animation.Track("/objects/" + i + "/rotation", keys()));
                tracks.add(new Animation.Track("/objects/" + i + "/center/" + random.nextInt(3), keys()));
            } else if (o.shape() instanceof Cube) {
                tracks.add(new Animation.Track("/objects/" + i + "/rotation/1", keys()));
            } else if (o.shape() instanceof Mesh mesh
                    && !mesh.transform().steps().isEmpty()) {
                String step = animated(mesh.transform().steps().get(0));
                tracks.add(new Animation.Track("/objects/" + i + "/transform/0/" + step, keys()));
            } else if (o.material().color() instanceof Texture.Solid
                    && !(o.material() instanceof Material.Scattering)
                    && o.material().parts().isEmpty()) {
                boolean linear = ((Texture.Solid) o.material().color()).color() instanceof Rgb;
                tracks.add(new Animation.Track(
                        "/objects/" + i + "/material/color/" + (linear ? "linear/2" : "2"), keys()));
            }
        }
        List<Animation.Track> eased = new ArrayList<>();
        Animation.Easing[] easings = Animation.Easing.values();
        tracks.forEach(
                t -> eased.add(new Animation.Track(t.target(), t.keys(), easings[random.nextInt(easings.length)])));
        double shutter = random.nextBoolean() ? 0 : (1 + random.nextInt(1000)) / 1000.0;
        return new Animation(
                1 + random.nextInt(1000), positive(), eased, shutter, 1 + random.nextInt(Animation.MOST_INSTANTS));
    }

    /** Where a shading's background has a number. */
    private String animated(Shading shading) {
        if (shading instanceof Shading.Physical physical) {
            return physical.background() instanceof Shading.Background.Constant
                    ? "linear/" + random.nextInt(3)
                    : physical.background() instanceof Shading.Background.Picture ? "rotation" : "elevation";
        }
        return "" + random.nextInt(3);
    }

    /** Where a step has a number. */
    private String animated(Transform.Step step) {
        if (step instanceof Transform.Scale) {
            return "scale/" + random.nextInt(3);
        } else if (step instanceof Transform.Rotate) {
            return "rotate/" + random.nextInt(3);
        } else if (step instanceof Transform.RotateAbout) {
            return random.nextBoolean() ? "angle" : "axis/" + random.nextInt(3);
        }
        return step instanceof Transform.Translate ? "translate/" + random.nextInt(3) : "matrix/" + random.nextInt(12);
    }

    private Animation.Track track(String light, Emission emission) {
        Rgb v = emission.value();
        boolean one = v.equals(Rgb.gray(v.r())) && random.nextBoolean();
        return new Animation.Track(
                light + Fields.word(emission.quantity()) + (one ? "" : "/" + random.nextInt(3)), keys());
    }

    private TreeMap<Integer, BigDecimal> keys() {
        TreeMap<Integer, BigDecimal> keys = new TreeMap<>();
        for (int i = random.nextInt(4); i >= 0; i--) {
            keys.put(random.nextInt(i + 1) * 1000, decimal());
        }
        return keys;
    }

    private Camera camera(Shading shading) {
        boolean hasMedium = shading instanceof Shading.Physical physical
                && physical.medium().isPresent();
        Camera camera = retry(this::camera);
        while (hasMedium && camera instanceof Camera.Isometric) {
            camera = retry(this::camera);
        }
        return camera;
    }

    private Camera camera() {
        ExactPoint o = point();
        Vec3 up = vector();
        Vec3 right = vector();
        switch (random.nextInt(5)) {
            case 0:
                Camera.Window window = new Camera.Window(
                        point(),
                        o,
                        o.plus(up),
                        o.plus(up).plus(right),
                        o.plus(right),
                        isPhysical ? 0 : Math.abs(number()));
                return isPhysical && random.nextBoolean() ? withPupil(window) : window;
            case 1:
                return new Camera.Perspective(
                        o,
                        point(),
                        up,
                        180 * unit(),
                        Camera.FieldOfViewAxis.values()[random.nextInt(4)],
                        handedness(),
                        isPhysical && random.nextBoolean() ? Optional.of(lens()) : Optional.empty());
            case 2:
                return new Camera.Orthographic(o, point(), up, positive(), handedness());
            case 3:
                return new Camera.Panorama(o, point(), up, random.nextBoolean() ? 0 : Math.abs(number()), handedness());
            default:
                return new Camera.Isometric(o, positive());
        }
    }

    private static Camera withPupil(Camera.Window w) {
        return new Camera.Window(
                w.eye(), w.lowerLeft(), w.upperLeft(), w.upperRight(), w.lowerRight(), w.distance() / 8);
    }

    private Camera.Handedness handedness() {
        return random.nextBoolean() ? Camera.Handedness.LEFT : Camera.Handedness.RIGHT;
    }

    private Camera.Lens lens() {
        double focus = positive();
        return new Camera.Lens(
                focus * random.nextInt(3) / 4, focus, random.nextBoolean() ? 0 : 3 + random.nextInt(5), number());
    }

    private Light light() {
        ExactPoint o = point();
        Vec3 u = vector();
        Vec3 v = vector();
        switch (random.nextInt(isPhysical ? 7 : 3)) {
            case 0:
                return new Light.Sphere(o, positive(), lightColor(), emission(Emission.RADIANCE_1));
            case 1:
                return new Light.Rectangle(
                        o,
                        o.plus(u),
                        o.plus(u).plus(v),
                        o.plus(v),
                        lightColor(),
                        random.nextBoolean(),
                        emission(Emission.RADIANCE_1));
            case 3:
                double angle = 180 * unit();
                double inner = random.nextBoolean() ? 0 : angle * random.nextDouble();
                return new Light.Spot(o, u, angle, inner, lightColor(), emission(Emission.INTENSITY_1));
            case 4:
                return new Light.Ies(
                        o,
                        imageFolder.resolve("lamp.ies"),
                        random.nextBoolean() ? Vec3.of(0, -1, 0) : u,
                        random.nextBoolean() ? 0 : number(),
                        lightColor(),
                        emission(Emission.INTENSITY_1));
            case 5:
                return new Light.Projector(
                        o,
                        (Texture.File) withName(file()),
                        u,
                        random.nextBoolean() ? Vec3.Y : v,
                        180 * unit(),
                        lightColor(),
                        emission(Emission.INTENSITY_1));
            case 6:
                double disk = Light.Distant.LEAST_ANGLE + unit();
                Emission irradiance =
                        random.nextBoolean() ? Emission.IRRADIANCE_1 : Emission.irradiance(new Rgb(3, 0, unit()));
                return new Light.Distant(
                        u, random.nextBoolean() ? Light.Distant.USUAL_ANGLE : disk, lightColor(), irradiance);
            default:
                return new Light.Point(o, lightColor(), emission(Emission.INTENSITY_1));
        }
    }

    private SceneObject object(String name) {
        Shape shape = retry(this::shape);
        List<Material> faces = new ArrayList<>();
        if (shape instanceof Cube && random.nextBoolean()) {
            for (int i = 0; i < 6; i++) {
                Material face = material();
                while (isTurned(face)) {
                    face = newMaterial();
                }
                faces.add(face);
            }
        }
        Material material = !faces.isEmpty() && random.nextBoolean() ? faces.get(0) : material();
        boolean canTurn = shape instanceof Mesh
                || shape instanceof Rectangle
                || shape instanceof Triangle
                || shape instanceof Sphere;
        while (isPhysical && (needsVolume(material) && !shape.enclosesVolume() || isTurned(material) && !canTurn)) {
            material = newMaterial();
        }
        return new SceneObject(name, shape, material, faces);
    }

    private static boolean needsVolume(Material material) {
        return material instanceof Material.Scattering
                || material instanceof Glass glass && !glass.roughness().isZero();
    }

    private Optional<Glossy.Conductor> conductor() {
        switch (random.nextInt(3)) {
            case 0:
                return Optional.empty();
            case 1:
                return Optional.of(Glossy.Metal.values()[random.nextInt(Glossy.Metal.values().length)].conductor());
            default:
                return Optional.of(new Glossy.Conductor(new Rgb(positive(), positive(), positive()), radiance()));
        }
    }

    private Shape shape() {
        ExactPoint o = point();
        Vec3 u = vector();
        Vec3 v = vector();
        switch (random.nextInt(10)) {
            case 0:
                return new Sphere(o, positive(), random.nextBoolean() ? 0 : number());
            case 1:
                return new Rectangle(o, o.plus(u), o.plus(u).plus(v), o.plus(v));
            case 2:
                return new Disk(o, u, positive());
            case 3:
                return new Cylinder(o, point(), positive(), random.nextBoolean());
            case 4:
                return new Cone(o, point(), positive(), random.nextBoolean() ? 0 : positive(), random.nextBoolean());
            case 5:
                return new Cube(o, positive(), random.nextBoolean() ? Vec3.ZERO : u);
            case 6:
                return new Box(o, point());
            case 7:
                return new Torus(o, u, positive(), positive());
            case 8:
                return new Triangle(o, point(), point());
            default:
                return mesh();
        }
    }

    private Mesh mesh() {
        MeshFiles.Origin.Normals normals = MeshFiles.Origin.Normals.values()[random.nextInt(3)];
        boolean hasCrease = normals == MeshFiles.Origin.Normals.SMOOTH && random.nextBoolean();
        String part = List.of("", "upper", "lower", "0").get(random.nextInt(4));
        MeshFiles.Origin origin = new MeshFiles.Origin(meshFile, part, normals, hasCrease ? 180 * unit() : 180);
        List<Transform.Step> steps = new ArrayList<>();
        for (int i = random.nextInt(4); i > 0; i--) {
            steps.add(step());
        }
        try {
            return new Mesh(origin.of(meshParts), Optional.of(origin), Transform.of(steps));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private Transform.Step step() {
        switch (random.nextInt(5)) {
            case 0:
                double s = number();
                return new Transform.Scale(random.nextBoolean() ? new Vec3(s, s, s) : vector());
            case 1:
                return new Transform.Rotate(vector());
            case 2:
                return new Transform.RotateAbout(vector(), number());
            case 3:
                return new Transform.Translate(point());
            default:
                return new Transform.Matrix(vector(), vector(), vector(), point());
        }
    }

    private Material material() {
        List<Material> named = new ArrayList<>(materials.values());
        return named.isEmpty() || random.nextBoolean() ? newMaterial() : named.get(random.nextInt(named.size()));
    }

    private Material newMaterial() {
        List<Texture> named = new ArrayList<>(textures.values());
        Texture color = named.isEmpty() || random.nextBoolean()
                ? Texture.of(surfaceColor())
                : named.get(random.nextInt(named.size()));
        boolean shadows = isPhysical || random.nextBoolean();
        Rgb light = radiance();
        double near = ultraviolet();
        switch (random.nextInt(!isPhysical ? 3 : hasDyes ? 9 : 8)) {
            case 0:
                return new Material.Matte(
                        color, shadows, random.nextBoolean() ? 0 : unit(), light, near, pattern(light, near));
            case 1:
                return new Material.Mirror(color, shadows, light, near, pattern(light, near));
            case 3:
                return new Glossy(
                        color, amount(), conductor(), random.nextBoolean(), light, near, pattern(light, near));
            case 4:
                return new Material.Scattering(
                        retry(this::medium),
                        random.nextBoolean() ? 1 : positive(),
                        random.nextBoolean() ? 0 : unit(),
                        random.nextBoolean() ? 0 : random.nextInt());
            case 5:
                return new Coated(
                        color,
                        random.nextBoolean() ? Texture.Amount.of(0) : amount(),
                        random.nextBoolean() ? Coated.USUAL_INDEX : 1 + 9 * unit(),
                        random.nextBoolean(),
                        light,
                        near,
                        pattern(light, near));
            case 6:
                return detailed();
            case 7:
                return new Principled(
                        color,
                        random.nextBoolean() ? Texture.Amount.of(0) : amount(),
                        random.nextBoolean() ? Texture.Amount.of(Principled.USUAL_ROUGHNESS) : amount(),
                        random.nextBoolean() ? Coated.USUAL_INDEX : 1 + 9 * unit(),
                        random.nextBoolean() ? 1 : unit(),
                        new Principled.Clearcoat(
                                random.nextBoolean() ? 0 : unit(),
                                random.nextBoolean() ? Texture.Amount.of(0) : amount()),
                        new Principled.Sheen(random.nextBoolean() ? 0 : unit(), random.nextBoolean() ? 0 : unit()),
                        light,
                        near,
                        pattern(light, near));
            case 8:
                return retry(() -> new Material.Fluorescent(
                        color, wavelengths(), wavelengths(), unit(), light, near, pattern(light, near)));
            default:
                return retry(() -> new Glass(
                        color,
                        positive(),
                        random.nextBoolean() ? 1 : unit(),
                        random.nextBoolean() ? 0 : random.nextInt(),
                        shadows,
                        random.nextBoolean() ? Texture.Amount.of(0) : amount(),
                        radiance(),
                        random.nextBoolean(),
                        hasDyes || random.nextBoolean() ? OptionalDouble.empty() : OptionalDouble.of(positive()),
                        random.nextInt(4) == 0,
                        opaque()));
        }
    }

    /** What the opaque share of glass may be made of. */
    private Optional<Material> opaque() {
        return random.nextBoolean()
                ? Optional.empty()
                : Optional.of(new Glossy(
                        Texture.of(surfaceColor()),
                        amount(),
                        Optional.empty(),
                        true,
                        Rgb.BLACK,
                        0,
                        Material.EmissionPattern.EVEN));
    }

    /** The points and sides of a surface that glow. */
    private Material.EmissionPattern pattern(Rgb light, double near) {
        if (light.equals(Rgb.BLACK) && near == 0 || random.nextBoolean()) {
            return Material.EmissionPattern.EVEN;
        }
        List<Texture> named = new ArrayList<>(textures.values());
        Texture map = named.isEmpty() ? Texture.of(surfaceColor()) : named.get(random.nextInt(named.size()));
        return new Material.EmissionPattern(
                random.nextBoolean() ? Optional.empty() : Optional.of(map),
                Material.EmissionPattern.Side.values()[random.nextInt(3)]);
    }

    /** A material that is made of others. */
    private Material detailed() {
        Material of = part();
        switch (random.nextInt(4)) {
            case 0:
                return new Composite.Mix(of, part(), amount());
            case 1:
                return new Composite.Mask(of, amount());
            case 2:
                Texture.File file = file();
                Texture normals = new Texture.File(file.file(), file.filter(), Texture.Encoding.LINEAR);
                return new Composite.NormalMap(
                        of, withName(random.nextBoolean() ? normals : Texture.of(surfaceColor())));
            default:
                return new Composite.Bump(of, withName(file()), number());
        }
    }

    /** A material that others may be made of, with a name or without one. */
    private Material part() {
        while (true) {
            Material m = material();
            try {
                return new Composite.Mask(m, Texture.of(Rgb.WHITE)).of();
            } catch (IllegalArgumentException e) {
                // It glows, or is not opaque; the next one.
            }
        }
    }

    private Texture.Amount amount() {
        if (random.nextBoolean()) {
            return Texture.Amount.of(unit());
        }
        Texture.Amount.Channel[] channels = Texture.Amount.Channel.values();
        return retry(() -> new Texture.Amount.Textured(
                withName(texture()), channels[random.nextInt(channels.length)], random.nextBoolean() ? 1 : unit()));
    }

    /** A texture that the scene has a name for. */
    private Texture withName(Texture texture) {
        if (!textures.containsValue(texture)) {
            textures.put("map " + textures.size(), texture);
        }
        return texture;
    }

    private static boolean isTurned(Material material) {
        return material instanceof Composite.NormalMap
                || material instanceof Composite.Bump
                || material.parts().stream().anyMatch(RandomScenes::isTurned);
    }

    private double ultraviolet() {
        return random.nextBoolean() ? 0 : Math.abs(number());
    }

    private Material.WavelengthBand wavelengths() {
        double low = 300 + 400 * unit();
        return new Material.WavelengthBand(low, low + 0.25 + 75 * unit());
    }

    private Texture.File file() {
        return new Texture.File(
                imageFolder.resolve("ice.png"),
                Texture.Filter.values()[random.nextInt(2)],
                Texture.Encoding.values()[random.nextInt(2)]);
    }

    private Texture texture() {
        switch (random.nextInt(3)) {
            case 0:
                return file();
            case 1:
                return new Texture.Checker(List.of(surfaceColor(), color()), positive());
            default:
                return Texture.of(surfaceColor());
        }
    }

    private Color surfaceColor() {
        return random.nextInt(3) == 0 ? new Rgb(unit(), unit(), unit()) : color();
    }

    private Color lightColor() {
        return random.nextInt(3) == 0 ? new Rgb(1e9 * unit(), 0, unit()) : color();
    }

    private Emission emission(Emission usual) {
        return random.nextInt(3) == 0
                ? usual
                : new Emission(
                        random.nextBoolean() ? usual.quantity() : Emission.Quantity.POWER, radiance(), ultraviolet());
    }

    private Rgb radiance() {
        switch (random.nextInt(3)) {
            case 0:
                return Rgb.BLACK;
            case 1:
                return Rgb.gray(positive());
            default:
                return new Rgb(Math.abs(number()), 0, Math.abs(number()));
        }
    }

    private DisplayRgb color() {
        if (random.nextBoolean()) {
            return DisplayRgb.ofBytes(random.nextInt(256), random.nextInt(256), random.nextInt(256));
        }
        return DisplayRgb.of(unit(), random.nextInt(5) == 0 ? -0.0 : unit(), unit());
    }

    private double unit() {
        return random.nextInt(4) == 0 ? Math.scalb(random.nextDouble(), -random.nextInt(1000)) : random.nextDouble();
    }

    private double positive() {
        return Math.max(Math.abs(number()), Double.MIN_VALUE);
    }

    private double number() {
        switch (random.nextInt(5)) {
            case 0:
                return random.nextInt(2001) - 1000;
            case 1:
                return (random.nextInt(200_001) - 100_000) / 1000.0;
            case 2:
                return Math.scalb(random.nextDouble() - 0.5, random.nextInt(600) - 300);
            case 3:
                return random.nextInt(20) == 0 ? -0.0 : random.nextGaussian();
            default:
                return Math.scalb(random.nextDouble() - 0.5, random.nextInt(8));
        }
    }

    private Vec3 vector() {
        return new Vec3(number(), number(), number());
    }

    private ExactPoint point() {
        return random.nextBoolean()
                ? ExactPoint.of(number(), number(), number())
                : new ExactPoint(decimal(), decimal(), decimal());
    }

    private BigDecimal decimal() {
        int digits = random.nextInt(10) == 0 ? 300 : 60;
        return new BigDecimal(new BigInteger(1 + random.nextInt(digits), random), random.nextInt(40) - 10)
                .multiply(BigDecimal.valueOf(random.nextBoolean() ? 1 : -1));
    }
}
