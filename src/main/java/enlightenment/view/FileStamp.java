package enlightenment.view;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.List;

/**
 * What changes with a file's content, without reading it.
 *
 * @param modified time of the last change in the file system's own resolution; null if there is no file
 * @param bytes its length; 0 if there is no file
 * @param key what the file system knows the file by, which changes when it is replaced; null where there is none
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
