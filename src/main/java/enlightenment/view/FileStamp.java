package enlightenment.view;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.List;

/**
 * Metadata of a file that change with its content, so that the content need not be read.
 *
 * @param modified time of the last change in the file system's own resolution; null if there is no file
 * @param bytes the file's length; 0 if there is no file
 * @param key the file system's identity of the file, which changes when the file is replaced; null where there is none
 */
record FileStamp(Object modified, long bytes, Object key) {
    static FileStamp of(Path file) {
        try {
            BasicFileAttributes a = Files.readAttributes(file, BasicFileAttributes.class);
            return new FileStamp(a.lastModifiedTime(), a.size(), a.fileKey());
        } catch (IOException e) {
            return new FileStamp(null, 0, null);
        }
    }

    /** The stamps of several files, in their order. */
    static List<FileStamp> of(List<Path> files) {
        return files.stream().map(FileStamp::of).toList();
    }
}
