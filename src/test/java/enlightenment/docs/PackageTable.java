package enlightenment.docs;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

/** The table of packages in docs/architecture.md. */
public final class PackageTable {
    private static final Pattern NAME = Pattern.compile("`([a-z.]+)`");

    private PackageTable() {}

    /**
     * A row.
     *
     * @param names of packages, without {@code enlightenment.}
     * @param exported whether its second column says yes
     */
    public record Row(List<String> names, boolean exported) {}

    /** The rows from the top. */
    public static List<Row> rows(Path project) throws IOException {
        List<Row> rows = new ArrayList<>();
        for (String line : Files.readAllLines(project.resolve("docs/architecture.md"))) {
            String[] cells = line.split("\\|");
            if (cells.length == 4 && cells[1].strip().startsWith("`")) {
                List<String> names = NAME.matcher(cells[1])
                        .results()
                        .map((MatchResult m) -> m.group(1))
                        .toList();
                rows.add(new Row(names, cells[2].strip().equals("yes")));
            }
        }
        return rows;
    }
}
