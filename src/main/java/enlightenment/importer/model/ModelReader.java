package enlightenment.importer.model;

import enlightenment.color.Rgb;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Transform;
import enlightenment.importer.support.ImportDraft;
import enlightenment.importer.support.InputFolder;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.mesh.MeshFiles;
import enlightenment.mesh.input.MtlFile;
import enlightenment.text.Plain;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** Reads PLY, OBJ, STL and Mitsuba's serialized meshes: one object for each material or shape of the file. */
public final class ModelReader {
    /** Of models that do not say: a light grey, as clay. */
    private static final Material CLAY = Material.Matte.of(Texture.of(new Rgb(0.6, 0.58, 0.55)));

    private ModelReader() {}

    /**
     * Reads a model.
     *
     * @throws IOException naming the file and the place for what is no such file
     */
    public static ImportDraft read(InputFolder folder) throws IOException {
        Path file = folder.imported();
        ImportDraft draft = new ImportDraft();
        MeshFiles.Contents meshes = MeshFiles.readFile(file, MeshFiles.MAX_TRIANGLES);
        if (file.toString().toLowerCase(Locale.ROOT).endsWith(".stl")) {
            draft.upIsZ();
        }
        if (meshes.hasColors()) {
            draft.notes().add("", "colours of vertices are left out");
        }
        Map<String, Material> materials = materials(folder, meshes.materialLibraries(), draft);
        List<MeshFiles.Part> parts = meshes.parts();
        for (int i = 0; i < parts.size(); i++) {
            MeshFiles.Part part = parts.get(i);
            String name = part.material();
            Material material = materials.get(name);
            if (material == null && !name.isEmpty()) {
                draft.notes().add("", "the material " + Plain.quoted(name) + " is not defined; it becomes grey");
            }
            Optional<MeshFiles.Origin> origin = Optional.of(new MeshFiles.Origin(
                    file, parts.size() == 1 ? "" : Integer.toString(i), MeshFiles.Origin.Normals.FILE, 180));
            draft.object(name, new Mesh(part.mesh(), origin, Transform.IDENTITY), material == null ? CLAY : material);
        }
        return draft;
    }

    private static Map<String, Material> materials(InputFolder folder, List<String> libraries, ImportDraft draft) {
        Map<String, Material> materials = new HashMap<>();
        for (String library : libraries) {
            try {
                for (MtlFile.Material m : MtlFile.read(folder.file(library))) {
                    Material material = new MtlMaterial(m, folder, draft.notes()).material();
                    materials.put(m.name(), material);
                    draft.material(m.name(), material);
                }
            } catch (IOException e) {
                draft.notes().add("", "a material library is left out: " + e.getMessage());
            }
        }
        return materials;
    }
}
