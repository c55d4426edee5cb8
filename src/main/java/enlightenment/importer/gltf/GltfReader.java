package enlightenment.importer.gltf;

import enlightenment.geometry.Mesh;
import enlightenment.geometry.Transform;
import enlightenment.importer.support.Affine;
import enlightenment.importer.support.ExtractedFiles;
import enlightenment.importer.support.ImportDraft;
import enlightenment.importer.support.ImportFailure;
import enlightenment.importer.support.InputFolder;
import enlightenment.importer.support.NamedChoice;
import enlightenment.math.InvalidValueException;
import enlightenment.mesh.TriangleMesh;
import enlightenment.text.Plain;
import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;

/** Reads glTF 2.0 (Khronos Group, ISO/IEC 12113): one object for each primitive of each node with a mesh. */
public final class GltfReader {
    private static final int MOST_OBJECTS = 2_000_000;
    private static final String INSTANCING = "EXT_mesh_gpu_instancing";

    /** Extensions that change what is seen, and are read or noted where they are used. */
    private static final Set<String> READ = Set.of(
            "KHR_mesh_quantization",
            "KHR_texture_transform",
            "KHR_lights_punctual",
            "KHR_materials_anisotropy",
            "KHR_materials_clearcoat",
            "KHR_materials_diffuse_transmission",
            "KHR_materials_dispersion",
            "KHR_materials_emissive_strength",
            "KHR_materials_ior",
            "KHR_materials_iridescence",
            "KHR_materials_pbrSpecularGlossiness",
            "KHR_materials_sheen",
            "KHR_materials_specular",
            "KHR_materials_transmission",
            "KHR_materials_unlit",
            "KHR_materials_variants",
            "KHR_materials_volume",
            INSTANCING);

    private final GltfElement document;
    private final ImportDraft draft = new ImportDraft();
    private final NodeTree nodes;
    private final GltfAccessors accessors;
    private final PrimitiveReader primitives;
    private final MaterialSet materials;
    private final PunctualLights lights;
    private final CameraReader cameras;
    private final NodeMotions motions;
    private final NodeTracks tracks;

    private GltfReader(
            GltfContainer file,
            InputFolder folder,
            ExtractedFiles extracted,
            NamedChoice camera,
            NamedChoice animation,
            double framesPerSecond)
            throws IOException {
        document = file.document();
        requireReadable();
        GltfBuffers buffers = new GltfBuffers(file, folder);
        ImageStore images = new ImageStore(document, buffers, folder, extracted);
        accessors = new GltfAccessors(document, buffers);
        motions = NodeMotions.read(document, accessors, animation, framesPerSecond, draft.notes());
        nodes = new NodeTree(document, motions);
        tracks = new NodeTracks(nodes, motions, draft.notes());
        primitives = new PrimitiveReader(accessors, buffers, draft.notes());
        materials = new MaterialSet(document, new GltfTextures(document, images, draft.notes()), draft);
        lights = new PunctualLights(document, draft);
        cameras = new CameraReader(document, draft, camera);
    }

    /**
     * Reads a {@code .gltf} or {@code .glb} file.
     *
     * @param extracted where pictures go that the file holds inside; empty for a temporary folder
     * @param camera the camera of the picture
     * @param animation the motion of the nodes
     * @param framesPerSecond of the file's animation
     * @throws enlightenment.scene.SceneException with the place in the file, for what is no such file, or needs what is not read here
     * @throws IOException if a file cannot be read or written
     */
    public static ImportDraft read(
            InputFolder folder,
            Optional<Path> extracted,
            NamedChoice camera,
            NamedChoice animation,
            double framesPerSecond)
            throws IOException {
        Path file = folder.imported();
        try {
            GltfContainer container = GltfContainer.read(file);
            GltfReader reader = new GltfReader(
                    container, folder, new ExtractedFiles(extracted), camera, animation, framesPerSecond);
            reader.readNodes();
            reader.cameras.requireChosen();
            reader.addAnimation();
            return reader.draft;
        } catch (FileSystemException e) {
            throw e;
        } catch (IOException | InvalidValueException e) {
            throw ImportFailure.at(file, 0, e.getMessage());
        }
    }

    private void requireReadable() throws IOException {
        String version = document.get("asset").text("version", "");
        if (!version.startsWith("2.")) {
            throw document.failure("asset/version: must be 2.0, not " + Plain.quoted(version));
        }
        for (String extension : document.texts("extensionsRequired")) {
            if (!READ.contains(extension)) {
                throw document.failure("extensionsRequired: the file needs " + Plain.quoted(extension)
                        + ", which cannot be read: export without it");
            }
        }
        noteLosses();
    }

    private void noteLosses() throws IOException {
        if (document.extensions().contains("EXT_lights_image_based")) {
            draft.notes().add("", "EXT_lights_image_based is left out");
            draft.leaveOutLight();
        }
    }

    private void addAnimation() throws IOException {
        tracks.animation().ifPresent(draft::animation);
        if (motions.animation().isPresent() && tracks.animation().isEmpty()) {
            draft.notes()
                    .add(
                            "animations/" + motions.animation().getAsInt(),
                            "it moves nothing that is seen, and is left out");
        }
    }

    private void readNodes() throws IOException {
        for (int index : nodes.nodes()) {
            GltfElement node = nodes.node(index);
            boolean isSeenFrom = cameras.isSeenFrom(node);
            boolean isLight = PunctualLights.isOn(node);
            if (isSeenFrom || isLight) {
                NodePoses poses = tracks.poses(index);
                if (isSeenFrom) {
                    cameras.look(poses, tracks);
                }
                if (isLight) {
                    lights.add(node, poses, tracks);
                }
            }
            int meshes = document.size("meshes");
            if (node.has("mesh")) {
                GltfElement mesh =
                        document.item("meshes", node.index("mesh", meshes).orElseThrow());
                readMesh(
                        new Place(index, node, node.has("skin") ? Optional.of(skinned(node)) : Optional.empty()), mesh);
            }
        }
    }

    /**
     * Where a mesh is.
     *
     * @param index the number of its node
     * @param skin the map to the scene of a mesh that is bound to joints, which stands; empty for one that is where its node is
     */
    private record Place(int index, GltfElement node, Optional<Affine> skin) {}

    /**
     * The map of a mesh that is bound to joints, whose own node has no influence: that of its first joint. All joints have the same one as long
     * as they stand as they did when the mesh was bound to them.
     */
    private Affine skinned(GltfElement node) throws IOException {
        draft.notes().add(node.place(), "its skin is left out: the mesh has the shape that it is bound in");
        GltfElement skin = document.item(
                "skins", node.index("skin", document.size("skins")).orElseThrow());
        int[] joints = skin.indices("joints", document.size("nodes"));
        if (joints.length == 0) {
            throw skin.failure("has no joints");
        }
        Affine joint = nodes.toScene(joints[0]);
        if (joint == null) {
            throw skin.failure("has a joint that is not in the scene: node " + joints[0]);
        }
        if (!skin.has("inverseBindMatrices")) {
            return joint;
        }
        float[] all = accessors.numbers(skin, "inverseBindMatrices", "MAT4").values();
        double[] columns = new double[16];
        for (int i = 0; i < columns.length; i++) {
            columns[i] = all[i];
        }
        try {
            return joint.after(NodeTree.ofColumns(columns));
        } catch (IllegalArgumentException e) {
            throw skin.failure("inverseBindMatrices: " + e.getMessage());
        }
    }

    private void readMesh(Place place, GltfElement mesh) throws IOException {
        String name = Plain.excerpt(place.node.text("name", mesh.text("name", "")));
        GltfElement instancing = place.node.extension(INSTANCING);
        for (GltfElement primitive : mesh.items("primitives")) {
            Optional<TriangleMesh> read = primitives.mesh(primitive, materials.frame(primitive));
            if (read.isEmpty()) {
                continue;
            }
            TriangleMesh triangles = materials.whole(primitive, read.get());
            if (instancing.isPresent()) {
                readInstances(place, instancing.get("attributes"), name, primitive, triangles);
            } else {
                place(place, name, primitive, triangles, Affine.IDENTITY);
            }
        }
    }

    /** @param inner the map from the coordinates of the mesh to those of its node */
    private void place(Place place, String name, GltfElement primitive, TriangleMesh triangles, Affine inner)
            throws IOException {
        if (draft.objects().size() >= MOST_OBJECTS) {
            throw place.node.failure("is one mesh too many: there are " + MOST_OBJECTS + " already");
        }
        boolean moves = place.skin.isEmpty() && nodes.moves(place.index);
        try {
            Transform transform = moves
                    ? tracks.transform(place.index, inner)
                    : place.skin.orElse(nodes.toScene(place.index)).after(inner).transform();
            draft.object(name, Mesh.of(triangles, transform), materials.material(primitive, triangles));
        } catch (InvalidValueException e) {
            draft.notes()
                    .add(place.node.place(), "its mesh is left out: it is scaled to nothing, or beyond all numbers");
            return;
        }
        if (moves) {
            tracks.move(draft.objects().size() - 1, place.index, inner);
        }
    }

    /** The instances of EXT_mesh_gpu_instancing: each is scaled, turned and moved within its node. */
    private void readInstances(
            Place node, GltfElement attributes, String name, GltfElement primitive, TriangleMesh triangles)
            throws IOException {
        int count = -1;
        for (String key : attributes.keys()) {
            if (!key.startsWith("_")) {
                int n = accessors.numbers(attributes, key, "VEC3", "VEC4").count();
                if (count >= 0 && n != count) {
                    throw attributes.failure("has attributes of different numbers of elements");
                }
                count = n;
            }
        }
        for (int i = 0; i < count; i++) {
            NodeTree.Placing placing = new NodeTree.Placing(
                    element(attributes, "TRANSLATION", "VEC3", i, 0, 0, 0),
                    element(attributes, "ROTATION", "VEC4", i, 0, 0, 0, 1),
                    element(attributes, "SCALE", "VEC3", i, 1, 1, 1));
            place(node, name, primitive, triangles, placing.affine());
        }
    }

    private double[] element(GltfElement attributes, String key, String type, int index, double... otherwise)
            throws IOException {
        if (!attributes.has(key)) {
            return otherwise;
        }
        GltfAccessors.Numbers numbers = accessors.numbers(attributes, key, type);
        double[] v = new double[otherwise.length];
        for (int c = 0; c < v.length; c++) {
            v[c] = numbers.values()[index * v.length + c];
        }
        return v;
    }
}
