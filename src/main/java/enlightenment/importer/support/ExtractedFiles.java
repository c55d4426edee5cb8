package enlightenment.importer.support;

import enlightenment.file.FileFailure;
import enlightenment.file.TemporaryFolder;
import enlightenment.file.WholeFile;
import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** Pictures that an imported file holds inside, or that are made of its own, as files. Their names are made here, and no file is replaced. */
public final class ExtractedFiles {
    private final Optional<Path> folder;
    private TemporaryFolder temporary;
    private int count;

    /** @param folder where they go, made when it is needed; empty for a temporary folder that goes when the process ends */
    public ExtractedFiles(Optional<Path> folder) {
        this.folder = folder;
    }

    /**
     * Writes the next file.
     *
     * @param extension of its name, without the dot
     * @throws FileSystemException if it cannot be written or is there
     */
    public Path write(String extension, WholeFile.Content content) throws FileSystemException {
        String name = "image-" + (count + 1) + "." + extension;
        Path file = Path.of(name);
        try {
            file = place(name);
            if (Files.exists(file)) {
                throw new FileAlreadyExistsException(file.toString());
            }
            WholeFile.write(file, content);
        } catch (FileSystemException e) {
            throw e;
        } catch (IOException e) {
            throw FileFailure.because(file, e.getMessage());
        }
        count++;
        return file;
    }

    private Path place(String name) throws IOException {
        if (folder.isPresent()) {
            return Files.createDirectories(folder.get()).resolve(name);
        }
        if (temporary == null) {
            temporary = new TemporaryFolder();
        }
        return temporary.file(name);
    }
}
