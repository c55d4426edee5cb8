package enlightenment.importer.support;

import enlightenment.file.FileFailure;
import enlightenment.file.NumberedFiles;
import enlightenment.file.TemporaryFolder;
import enlightenment.file.WholeFile;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Pictures that an imported file holds inside, or that are made of its own, as files. Their names are made here, and no file is replaced: see
 * {@link NumberedFiles}.
 */
public final class ExtractedFiles {
    private static final ImageFiles.PngOptions DEEP = ImageFiles.PngOptions.DEFAULT.withDepth(16);

    private final Optional<Path> folder;

    /** Null before the first file. */
    private NumberedFiles files;

    /** Null unless there is no other folder. */
    private TemporaryFolder temporary;

    /** @param folder where they go, made when it is needed; empty for a temporary folder that goes when the process ends */
    public ExtractedFiles(Optional<Path> folder) {
        this.folder = folder;
    }

    /**
     * Writes the next file, or finds it from an earlier import.
     *
     * @param extension of its name, without the dot
     * @param content its bytes, which must be the same each time
     * @throws FileSystemException if it cannot be written
     */
    public Path write(String extension, WholeFile.Content content) throws FileSystemException {
        try {
            if (files == null) {
                files = new NumberedFiles(place(), "image");
            }
            Path file = files.write(extension, content);
            return temporary == null ? file : temporary.file(file.getFileName().toString());
        } catch (FileSystemException e) {
            throw e;
        } catch (IOException e) {
            throw FileFailure.because(folder.orElse(Path.of("image." + extension)), e.getMessage());
        }
    }

    /**
     * Writes a picture as a PNG file of 16 bits.
     *
     * @throws FileSystemException as {@link #write}
     */
    public Path picture(Image image) throws FileSystemException {
        return write("png", out -> ImageFiles.toPng(image, out, DEEP));
    }

    private Path place() throws IOException {
        if (folder.isPresent()) {
            return Files.createDirectories(folder.get());
        }
        temporary = new TemporaryFolder();
        return temporary.folder();
    }
}
