package enlightenment.importer.pbrt;

import enlightenment.importer.support.ExtractedFiles;
import enlightenment.importer.support.ImportDraft;
import enlightenment.importer.support.InputFolder;
import enlightenment.scene.SceneException;
import java.io.IOException;

/** Reads scenes of pbrt-v4. */
public final class PbrtReader {
    private PbrtReader() {}

    /**
     * Reads a scene with the files that it includes.
     *
     * @param extracted where the picture of an infinite light is written, which has another form here
     * @throws SceneException naming file and line for what is no scene of pbrt-v4
     * @throws IOException if a file cannot be read
     */
    public static ImportDraft read(InputFolder folder, ExtractedFiles extracted) throws IOException {
        ImportDraft draft = new ImportDraft();
        try (TokenSource in = new TokenSource(folder)) {
            new Directives(in, draft, extracted).read();
        }
        return draft;
    }
}
