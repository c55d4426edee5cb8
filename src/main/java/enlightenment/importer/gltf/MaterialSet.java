package enlightenment.importer.gltf;

import enlightenment.importer.support.Fillings;
import enlightenment.importer.support.ImportDraft;
import enlightenment.material.Material;
import enlightenment.mesh.TriangleMesh;
import enlightenment.text.Plain;
import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/** The materials of a glTF file; each is read once, and gets its name in the scene when it is first used. */
final class MaterialSet {
    private static final int DEFAULT = -1;

    private final GltfElement document;
    private final GltfTextures textures;
    private final ImportDraft draft;
    private final Map<Integer, MaterialReader> readers = new HashMap<>();
    private final Map<Integer, Optional<TextureFrame>> frames = new HashMap<>();
    private final Map<Integer, Material> solids = new HashMap<>();
    private final Map<Integer, Material> sheets = new HashMap<>();

    MaterialSet(GltfElement document, GltfTextures textures, ImportDraft draft) {
        this.document = document;
        this.textures = textures;
        this.draft = draft;
    }

    private int index(GltfElement primitive) throws IOException {
        OptionalInt index = primitive.index("material", document.size("materials"));
        return index.orElse(DEFAULT);
    }

    private MaterialReader reader(int index) throws IOException {
        if (!readers.containsKey(index)) {
            GltfElement material =
                    index == DEFAULT ? GltfElement.absent("the default material") : document.item("materials", index);
            readers.put(index, new MaterialReader(material, textures, draft.notes()));
        }
        return readers.get(index);
    }

    /** The texture coordinates that the material of a primitive uses. */
    Optional<TextureFrame> frame(GltfElement primitive) throws IOException {
        int index = index(primitive);
        if (!frames.containsKey(index)) {
            frames.put(index, reader(index).frame());
        }
        return frames.get(index);
    }

    /** The mesh of a primitive, without small holes where its material fills it. */
    TriangleMesh whole(GltfElement primitive, TriangleMesh mesh) throws IOException {
        boolean isFilled = reader(index(primitive)).fillsVolume();
        return isFilled ? Fillings.whole(mesh, draft.notes(), primitive.place()) : mesh;
    }

    /** The material of a primitive that has become a mesh. */
    Material material(GltfElement primitive, TriangleMesh mesh) throws IOException {
        int index = index(primitive);
        boolean isClosed = mesh.isClosed();
        Map<Integer, Material> known = isClosed ? solids : sheets;
        Material material = known.get(index);
        if (material == null) {
            material = reader(index).material(isClosed);
            known.put(index, material);
            keep(index, material);
        }
        if (frame(primitive).isPresent() && !reader(index).repeats() && leavesSquare(mesh)) {
            draft.notes().add(primitive.place(), "textures that end or are mirrored at their edge repeat");
        }
        return material;
    }

    private void keep(int index, Material material) throws IOException {
        if (index == DEFAULT || draft.materials().containsValue(material)) {
            return;
        }
        String name = Plain.excerpt(document.item("materials", index).text("name", ""));
        String base = name.isEmpty() ? "material" : name;
        String free = name;
        for (int n = index; free.isEmpty() || draft.materials().containsKey(free); n++) {
            free = base + " " + n;
        }
        draft.material(free, material);
    }

    private static boolean leavesSquare(TriangleMesh mesh) {
        for (int i = 0; mesh.hasUv() && i < mesh.vertices(); i++) {
            double u = mesh.uv(i, 0);
            double v = mesh.uv(i, 1);
            if (u < 0 || u > 1 || v < 0 || v > 1) {
                return true;
            }
        }
        return false;
    }
}
