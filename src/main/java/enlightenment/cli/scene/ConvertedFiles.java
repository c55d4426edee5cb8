package enlightenment.cli.scene;

import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.StandardStreams;
import enlightenment.file.NumberedFiles;
import enlightenment.file.WholeFile;
import enlightenment.geometry.Mesh;
import enlightenment.importer.SceneImporter;
import enlightenment.mesh.MeshFiles;
import enlightenment.mesh.TriangleMesh;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * A scene file that is converted, and a folder beside it, {@code OUT-files}, with what it needs and no file holds: pictures from inside the input, and
 * meshes that were not files of their own. Files of that folder are never replaced ({@link NumberedFiles}).
 */
final class ConvertedFiles {
    private final Path output;
    private final Path folder;

    /** @param output the scene file, or standard output */
    ConvertedFiles(Path output) {
        this.output = output;
        String name = output.getFileName().toString();
        int dot = name.lastIndexOf('.');
        folder = output.toAbsolutePath().resolveSibling((dot > 0 ? name.substring(0, dot) : name) + "-files");
    }

    /** The options of the import, with the folder for its pictures, if there is one. */
    SceneImporter.Options options(SceneImporter.Options chosen) {
        return StandardStreams.isNamed(output) ? chosen : chosen.withExtracted(folder);
    }

    /** @throws CliException if the scene has a mesh that is in no file: standard output has no place for it */
    void refuseMeshes(Scene scene) {
        if (scene.objects().stream()
                .anyMatch(o -> o.shape() instanceof Mesh mesh && mesh.origin().isEmpty())) {
            throw CliException.wrongUsage("the scene has meshes that need files of their own: name a file to write");
        }
    }

    /** Writes the scene, and before it the meshes that are in no file. */
    void write(Scene scene) throws IOException {
        Map<TriangleMesh, String> names = new HashMap<>();
        NumberedFiles files = new NumberedFiles(folder, "mesh");
        for (var object : scene.objects()) {
            if (object.shape() instanceof Mesh mesh
                    && mesh.origin().isEmpty()
                    && !names.containsKey(mesh.triangles())) {
                names.put(mesh.triangles(), write(mesh.triangles(), files));
            }
        }
        SceneWriter.FileNames relative =
                SceneWriter.relativeTo(output.toAbsolutePath().getParent());
        WholeFile.write(output, SceneWriter.toJson(scene, new SceneWriter.FileNames() {
            @Override
            public String of(Path file) {
                return relative.of(file);
            }

            @Override
            public Optional<String> of(TriangleMesh mesh) {
                return Optional.ofNullable(names.get(mesh));
            }
        }));
    }

    private String write(TriangleMesh mesh, NumberedFiles files) throws IOException {
        Files.createDirectories(folder);
        Path file = files.write("ply", out -> MeshFiles.writePly(mesh, out));
        return folder.getFileName() + "/" + file.getFileName();
    }
}
