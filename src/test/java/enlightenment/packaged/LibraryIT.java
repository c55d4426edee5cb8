package enlightenment.packaged;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.docs.PackageTable;
import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.module.ModuleDescriptor;
import java.lang.module.ModuleFinder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.jar.JarFile;
import java.util.spi.ToolProvider;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.w3c.dom.NodeList;

/** The library as a program meets it: the jar, its module, and what comes along. */
class LibraryIT {
    private static final Path PROGRAMS = Packages.PROJECT.resolve("src/test/resources/packaged");
    private static final Path JACKSON = Packages.dependency("jackson-core-");

    @TempDir
    Path folder;

    @Test
    void aModularProgramRendersWithJacksonCoreAndTheModulesThatAreRequiredOnly() throws Exception {
        compile("program");
        Packages.Run run = Packages.run(
                folder,
                Map.of(),
                Packages.JAVA,
                "-Djava.awt.headless=true",
                "--limit-modules",
                "enlightenment",
                "-p",
                path(folder.resolve("program"), Packages.LIBRARY, JACKSON),
                "-m",
                "program/program.Embedding",
                Packages.SCENE.toAbsolutePath());
        assertEquals(0, run.code(), run::toString);
        assertEquals("embedded", run.out().strip());
        assertEquals("", run.err());
    }

    @Test
    void aProgramMayRequireJacksonBesides() throws Exception {
        compile("jackson");
        Packages.Run run = Packages.run(
                folder,
                Map.of(),
                Packages.JAVA,
                "-p",
                path(folder.resolve("jackson"), Packages.LIBRARY, JACKSON),
                "-m",
                "both/both.Both",
                Packages.SCENE.toAbsolutePath());
        assertEquals(0, run.code(), run::toString);
        assertEquals("both true", run.out().strip());
    }

    @Test
    void theModuleExportsWhatTheArchitecturePageSays() throws IOException {
        ModuleDescriptor module = module();
        Set<String> exported = module.exports().stream()
                .map(ModuleDescriptor.Exports::source)
                .map(name -> name.replaceFirst("^enlightenment\\.", ""))
                .collect(Collectors.toCollection(TreeSet::new));
        assertEquals(documentedExports(), exported);
        assertTrue(module.exports().stream().noneMatch(ModuleDescriptor.Exports::isQualified));
        assertEquals(
                documentedPackagesOfCommands(),
                module.opens().stream()
                        .map(ModuleDescriptor.Opens::source)
                        .collect(Collectors.toCollection(TreeSet::new)));
    }

    @Test
    void whatTheModuleCannotDoWithoutIsLittle() {
        Set<String> needed = module().requires().stream()
                .filter(r -> !r.modifiers().contains(ModuleDescriptor.Requires.Modifier.STATIC))
                .map(ModuleDescriptor.Requires::name)
                .collect(Collectors.toSet());
        assertEquals(Set.of("java.base", "java.desktop", "jdk.jfr", "tools.jackson.core"), needed);
    }

    @Test
    void theJarHoldsOurClassesOnly() throws IOException {
        try (JarFile jar = new JarFile(Packages.LIBRARY.toFile())) {
            List<String> others = jar.stream()
                    .map(e -> e.getName())
                    .filter(name -> !name.endsWith("/"))
                    .filter(name -> !name.startsWith("enlightenment/") && !name.startsWith("META-INF/maven/"))
                    .sorted()
                    .toList();
            assertEquals(List.of("META-INF/LICENSE", "META-INF/MANIFEST.MF", "module-info.class"), others);
        }
    }

    /** The jar carries the pom that is installed and deployed with it. */
    @Test
    void whoDependsOnThePublishedPomInheritsJacksonCoreOnly() throws Exception {
        Element project = publishedPom();
        List<String> inherited = new ArrayList<>();
        for (Element dependency : children(child(project, "dependencies"))) {
            boolean optional = "true".equals(text(dependency, "optional"));
            String scope = text(dependency, "scope");
            if (!optional && (scope.isEmpty() || scope.equals("compile") || scope.equals("runtime"))) {
                inherited.add(text(dependency, "groupId") + ":" + text(dependency, "artifactId"));
            }
        }
        assertEquals(List.of("tools.jackson.core:jackson-core"), inherited);
        assertEquals("Apache-2.0", text(children(child(project, "licenses")).get(0), "name"));
    }

    private static ModuleDescriptor module() {
        return ModuleFinder.of(Packages.LIBRARY)
                .find("enlightenment")
                .orElseThrow()
                .descriptor();
    }

    /** The rows of the table of packages whose second column says yes. */
    private static Set<String> documentedExports() throws IOException {
        Set<String> names = new TreeSet<>();
        for (PackageTable.Row row : PackageTable.rows(Packages.PROJECT)) {
            if (row.exported()) {
                names.addAll(row.names());
            }
        }
        return names;
    }

    /** Whose options picocli fills in. */
    private static Set<String> documentedPackagesOfCommands() throws IOException {
        return PackageTable.rows(Packages.PROJECT).stream()
                .flatMap(row -> row.names().stream())
                .filter(name -> name.equals("cli") || name.startsWith("cli."))
                .map(name -> "enlightenment." + name)
                .collect(Collectors.toCollection(TreeSet::new));
    }

    private static Element publishedPom() throws Exception {
        try (JarFile jar = new JarFile(Packages.LIBRARY.toFile())) {
            var entry = jar.getEntry("META-INF/maven/enlightenment/enlightenment/pom.xml");
            return DocumentBuilderFactory.newDefaultInstance()
                    .newDocumentBuilder()
                    .parse(jar.getInputStream(entry))
                    .getDocumentElement();
        }
    }

    private static List<Element> children(Element parent) {
        List<Element> all = new ArrayList<>();
        NodeList nodes = parent.getChildNodes();
        for (int i = 0; i < nodes.getLength(); i++) {
            Node node = nodes.item(i);
            if (node instanceof Element element) {
                all.add(element);
            }
        }
        return all;
    }

    private static Element child(Element parent, String name) {
        return children(parent).stream()
                .filter(e -> e.getTagName().equals(name))
                .findFirst()
                .orElseThrow();
    }

    private static String text(Element parent, String name) {
        return children(parent).stream()
                .filter(e -> e.getTagName().equals(name))
                .map(e -> e.getTextContent().strip())
                .findFirst()
                .orElse("");
    }

    /** Compiles the program of this name with nothing but the library and Jackson's core on its module path. */
    private void compile(String name) throws IOException {
        List<String> arguments = new ArrayList<>(List.of(
                "--release",
                "17",
                "-Xlint:all",
                "-Werror",
                "--module-path",
                path(Packages.LIBRARY, JACKSON),
                "-d",
                folder.resolve(name).toString()));
        try (Stream<Path> files = Files.walk(PROGRAMS.resolve(name))) {
            files.map(Path::toString).filter(file -> file.endsWith(".java")).forEach(arguments::add);
        }
        StringWriter said = new StringWriter();
        PrintWriter writer = new PrintWriter(said, true);
        int code = ToolProvider.findFirst("javac").orElseThrow().run(writer, writer, arguments.toArray(String[]::new));
        assertEquals(0, code, said::toString);
    }

    private static String path(Path... entries) {
        return Stream.of(entries)
                .map(entry -> entry.toAbsolutePath().toString())
                .collect(Collectors.joining(File.pathSeparator));
    }
}
