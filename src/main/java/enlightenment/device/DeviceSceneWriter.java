package enlightenment.device;

import enlightenment.bsdf.FlatBsdf;
import enlightenment.bvh.BvhBuilder;
import enlightenment.bvh.ItemBoxes;
import enlightenment.frame.Bounds;
import enlightenment.primitive.FlatForm;
import enlightenment.primitive.MeshUnion;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Shading;
import enlightenment.texture.ImageTexture;
import enlightenment.world.CompiledScene;
import enlightenment.world.PhysicalScene;
import enlightenment.world.light.ClassicLight;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.material.TextureLookup;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

/** Writes the arrays of a {@link DeviceScene}; the code of the kernel says what a record holds, beside its sizes. */
final class DeviceSceneWriter {
    /** The numbers of a lens before those of its corners. */
    private static final int LENS_VECTORS = 12;

    /** Boxes of faces that touch others are asked one by one: a primitive with more is left to the host as a whole. */
    private static final int MOST_CONTACTS = 64;

    private static final int NONE = -1;
    private static final int CONTACT = 7;

    /** Stands for the meshes that are searched together. */
    private static final int JOINED = -1;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final NumberList.Doubles doubles = new NumberList.Doubles();
    private final NumberList.Ints ints = new NumberList.Ints();
    private final NumberList.Floats floats = new NumberList.Floats();
    private final Map<SurfaceMaterial, Integer> materialNumbers = new IdentityHashMap<>();
    private final List<SurfaceMaterial> materials = new ArrayList<>();
    private final Map<ImageTexture, Integer> imageNumbers = new IdentityHashMap<>();
    private final List<ImageTexture> images = new ArrayList<>();
    private final MeshWriter meshes = new MeshWriter();

    /** The meshes that are searched together, or null. */
    private final MeshUnion union;

    DeviceSceneWriter(CompiledScene scene, RenderSettings settings) {
        this.scene = scene;
        this.settings = settings;
        union = scene.accelerator.union();
    }

    DeviceScene write() {
        writeWhole();
        for (DeviceScene.Int slot : DeviceScene.Int.values()) {
            ints.add(0);
        }
        writeLens(scene.camera.lensForm());
        writeHierarchies();
        writePrimitives();
        writeUnion();
        set(DeviceScene.Int.MESHES, meshes.write(doubles, ints, floats));
        writeMaterials();
        writeImages();
        new LightWriter(scene, doubles, ints).write();
        boolean isPhysical = scene.physical != null;
        set(DeviceScene.Int.MAX_BOUNCES, isPhysical ? scene.physical.maxBounces : scene.classic.maxBounces());
        set(DeviceScene.Int.MAX_STRAIGHT, scene.crossings);
        set(
                DeviceScene.Int.LIGHT_POINTS,
                BuiltInMethod.RayTraceSettings.of(settings).shadowSamples());
        double[] boxes = scene.glassBoxes.numbers();
        set(DeviceScene.Int.GLASS_BOXES, doubles.add(boxes));
        set(DeviceScene.Int.GLASS_BOX_COUNT, boxes.length / 6);
        return new DeviceScene(
                isPhysical ? DeviceScene.Program.PHYSICAL : DeviceScene.Program.CLASSIC,
                doubles.toArray(),
                ints.toArray(),
                floats.toArray());
    }

    private void set(DeviceScene.Int slot, int value) {
        ints.set(slot.ordinal(), value);
    }

    /** In the order of {@link DeviceScene.Number}. */
    private void writeWhole() {
        Shading.Classic classic = scene.classic;
        double ambient = classic == null ? 0 : classic.ambient();
        doubles.add(ambient, classic == null ? 0 : classic.shadow(), 0, 0, settings.width(), settings.height());
        if (classic == null) {
            PhysicalScene physical = scene.physical;
            doubles.add(physical.backgroundR, physical.backgroundG, physical.backgroundB);
        } else {
            doubles.add(
                    classic.background().r(),
                    classic.background().g(),
                    classic.background().b());
        }
        doubles.add(scene.camera.linearForm());
    }

    /** As samples.cl reads it: at place 0 there is none. */
    private void writeLens(double[] lens) {
        set(DeviceScene.Int.LENS, lens.length == 0 ? 0 : doubles.add(lens));
        set(DeviceScene.Int.LENS_CORNERS, Math.max(lens.length - LENS_VECTORS, 0) / 2);
    }

    /** One hierarchy in which meshes that are searched together are one item, and one in which each is an item: the same if there are none. */
    private void writeHierarchies() {
        int n = scene.primitives.length;
        int[] all = IntStream.range(0, n).toArray();
        writeHierarchy(1, all);
        if (union == null) {
            shareHierarchy();
        } else {
            BitSet joined = new BitSet();
            for (int id : union.ids()) {
                joined.set(id);
            }
            IntStream others = IntStream.range(0, n).filter(id -> !joined.get(id));
            writeHierarchy(0, IntStream.concat(others, IntStream.of(JOINED)).toArray());
        }
    }

    private void shareHierarchy() {
        int reach = DeviceScene.Number.REACH.place();
        doubles.set(reach, doubles.get(reach + 1));
        for (DeviceScene.Int slot : List.of(DeviceScene.Int.BOXES, DeviceScene.Int.CHILDREN, DeviceScene.Int.ORDER)) {
            set(slot, ints.get(slot.ordinal() + 1));
        }
    }

    private void writeHierarchy(int number, int[] items) {
        IntFunction<Bounds> boxes = i -> items[i] == JOINED ? union.bounds() : scene.primitives[items[i]].bounds();
        BvhBuilder tree = new BvhBuilder(new ItemBoxes(items.length, boxes), () -> {});
        int[] order = Arrays.stream(tree.order()).map(i -> items[i]).toArray();
        doubles.set(DeviceScene.Number.REACH.place() + number, tree.reach());
        ints.set(DeviceScene.Int.BOXES.ordinal() + number, floats.add(tree.floats()));
        ints.set(DeviceScene.Int.CHILDREN.ordinal() + number, ints.add(tree.child()));
        ints.set(DeviceScene.Int.ORDER.ordinal() + number, ints.add(order));
    }

    /** The primitives of the scene by id, then the surfaces of the lights that can be seen. */
    private void writePrimitives() {
        NumberList.Ints records = new NumberList.Ints();
        Map<Integer, Integer> members = members();
        for (int id = 0; id < scene.primitives.length; id++) {
            Primitive p = scene.primitives[id];
            int[] faces = new int[p.faceCount()];
            for (int face = 0; face < faces.length; face++) {
                faces[face] = materialNumber(scene.material(id, face));
            }
            double[] contacts = scene.coincident.boxes(id);
            boolean areFew = contacts != null && contacts.length <= MOST_CONTACTS * CONTACT;
            FlatForm form = p.flatForm();
            records.add(
                    form.kind().ordinal(),
                    write(form, members.getOrDefault(id, NONE)),
                    ints.add(faces),
                    p.isSolid() ? 1 : 0,
                    areFew ? doubles.add(contacts) : 0,
                    areFew ? contacts.length / CONTACT : NONE,
                    scene.glassSolids.length == 0 ? 0 : scene.mediumRank[id],
                    medium(scene.inside(id)),
                    traits(p),
                    faceLights(id));
        }
        for (ClassicLight light : scene.visibleLights) {
            FlatForm form = light.surface.flatForm();
            records.add(form.kind().ordinal(), write(form, NONE), 0, 0, 0, 0, 0, 0, 0, NONE);
        }
        set(DeviceScene.Int.PRIMITIVES, ints.add(records.toArray()));
    }

    /** The numbers of a primitive's inside, as glass.cl reads them. */
    private int medium(SurfaceMaterial inside) {
        int place = doubles.add(inside.indexOfRefraction, inside.absorbs ? 1 : 0);
        doubles.add(inside.absorption());
        return place;
    }

    /** As rays.cl has them. */
    private static int traits(Primitive p) {
        return (p.isFlat() ? 1 : 0) | (p.isConvex() ? 2 : 0) | (p.support(0).isFlat() ? 4 : 0);
    }

    /** Where the indices of the lights are that the faces of a primitive are. */
    private int faceLights(int id) {
        if (scene.physical == null) {
            return NONE;
        }
        PhysicalScene physical = scene.physical;
        int[] all = IntStream.range(0, scene.primitives[id].faceCount())
                .map(face -> physical.lightOf(id, face))
                .toArray();
        return Arrays.stream(all).allMatch(light -> light < 0) ? NONE : ints.add(all);
    }

    /** By id of those meshes that are searched together: their numbers among these. */
    private Map<Integer, Integer> members() {
        Map<Integer, Integer> numbers = new HashMap<>();
        for (int k = 0; union != null && k < union.size(); k++) {
            numbers.put(union.id(k), k);
        }
        return numbers;
    }

    private int write(FlatForm form, int member) {
        int place = doubles.add(form.numbers());
        if (form.mesh() != null) {
            doubles.add(meshes.number(form.mesh()), member);
        }
        return place;
    }

    private void writeUnion() {
        if (union != null) {
            FlatForm form = union.flatForm();
            int place = doubles.add(form.numbers());
            doubles.add(meshes.number(form.mesh()), NONE);
            doubles.add(ints.add(union.firstTriangles()), ints.add(union.ids()), union.size());
            set(DeviceScene.Int.UNION, place);
        }
    }

    private int materialNumber(SurfaceMaterial material) {
        return materialNumbers.computeIfAbsent(material, m -> {
            materials.add(m);
            return materials.size() - 1;
        });
    }

    private void writeMaterials() {
        boolean takesNarrow =
                scene.physical != null && scene.physical.hasCausticPass() && scene.physical.caustics.takesNarrow();
        NumberList.Ints records = new NumberList.Ints();
        for (SurfaceMaterial m : materials) {
            TextureLookup texture = m.texture();
            int place = doubles.add(texture.numbers());
            FlatBsdf bsdf = m.bsdf.flatForm();
            doubles.add(m.indexOfRefraction, m.transparency, m.glowR, m.glowG, m.glowB);
            doubles.add(bsdf.numbers());
            records.add(
                    bsdf.kind().ordinal(),
                    lookup(texture).ordinal(),
                    imageNumber(texture.image()),
                    m.receivesShadows ? 1 : 0,
                    place,
                    m.isBlack ? 1 : 0,
                    m.isDelta ? 1 : 0,
                    takesNarrow && m.bsdf.isNarrow() ? 1 : 0,
                    m.glows ? (m.glowsTo(Ray.OUTSIDE) ? 1 : 0) | (m.glowsTo(Ray.INSIDE) ? 2 : 0) : 0,
                    m.isGlass ? 1 : 0);
        }
        set(DeviceScene.Int.MATERIALS, ints.add(records.toArray()));
    }

    private static DeviceScene.Lookup lookup(TextureLookup texture) {
        if (texture.hasImage()) {
            return texture.isBilinear() ? DeviceScene.Lookup.BILINEAR : DeviceScene.Lookup.NEAREST;
        }
        return texture.isTextured() ? DeviceScene.Lookup.CHECKER : DeviceScene.Lookup.SOLID;
    }

    private int imageNumber(ImageTexture image) {
        if (image == null) {
            return 0;
        }
        return imageNumbers.computeIfAbsent(image, i -> {
            images.add(i);
            return images.size() - 1;
        });
    }

    private void writeImages() {
        NumberList.Ints records = new NumberList.Ints();
        for (ImageTexture image : images) {
            boolean isPacked = image.packed() != null;
            records.add(
                    image.width(),
                    image.height(),
                    isPacked ? ints.add(image.packed()) : NONE,
                    isPacked ? 0 : floats.add(image.components()),
                    isPacked ? doubles.add(image.values()) : 0);
        }
        set(DeviceScene.Int.IMAGES, ints.add(records.toArray()));
    }
}
