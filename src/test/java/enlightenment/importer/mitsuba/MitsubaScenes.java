package enlightenment.importer.mitsuba;

import enlightenment.importer.support.ExtractedFiles;
import enlightenment.importer.support.ImportDraft;
import enlightenment.importer.support.InputFolder;
import enlightenment.importer.support.NamedChoice;
import enlightenment.material.Material;
import enlightenment.scene.SceneException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Assertions;

/** Small scenes, written to a folder and read. */
record MitsubaScenes(Path folder) {
    Path write(String name, String content) throws IOException {
        return Files.writeString(folder.resolve(name), content);
    }

    ImportDraft read(String elements) throws IOException {
        return read("3.0.0", elements);
    }

    ImportDraft read(String version, String elements) throws IOException {
        return read(write("scene.xml", "<scene version=\"" + version + "\">\n" + elements + "\n</scene>\n"));
    }

    private ImportDraft read(Path file) throws IOException {
        return MitsubaReader.read(
                new InputFolder(file),
                new ExtractedFiles(Optional.of(folder.resolve("made"))),
                NamedChoice.camera(Optional.empty()));
    }

    /** The material of a sphere with this bsdf. */
    Material material(String bsdf) throws IOException {
        return read("<shape type=\"sphere\">" + bsdf + "</shape>")
                .objects()
                .get(0)
                .material();
    }

    /** The only line by which a file is refused. */
    String refused(Path file) {
        SceneException e = Assertions.assertThrows(SceneException.class, () -> read(file));
        Assertions.assertEquals(1, e.problems().size());
        Assertions.assertEquals(1, e.problems().get(0).toString().lines().count());
        return e.getMessage();
    }
}
