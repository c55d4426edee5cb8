@echo off
rem Starts Enlightenment: finds Java 17 or newer, and starts it from an archive of classes in the user's cache if there is one.
rem
rem JAVA_HOME            the Java to run with; without it, java on the PATH
rem JAVA_OPTS            options for Java
rem ENLIGHTENMENT_OPTS   the same, for this program only; they come last and so prevail
rem LOCALAPPDATA         where the archive is kept, in the folder enlightenment
rem ENLIGHTENMENT_NO_ARCHIVE   if not empty, no render makes an archive by itself

setlocal DisableDelayedExpansion
set "E_PROGRAM=@project.version@"
for %%I in ("%~dp0..") do set "E_HOME=%%~fI"
set "E_JAR=%E_HOME%\lib\enlightenment.jar"
if not exist "%E_JAR%" (
    >&2 echo enlightenment: there is no "%E_JAR%": the launcher belongs beside the folder lib of the application's zip
    exit /b 1
)

rem Java.
set "E_JAVA="
if defined JAVA_HOME (
    set "E_JAVA=%JAVA_HOME%\bin\java.exe"
) else (
    for %%I in (java.exe) do set "E_JAVA=%%~$PATH:I"
)
if not defined E_JAVA (
    >&2 echo enlightenment: no Java found: install Java 17 or newer, or let JAVA_HOME name its folder
    exit /b 1
)
if not exist "%E_JAVA%" (
    >&2 echo enlightenment: JAVA_HOME is "%JAVA_HOME%", but there is no bin\java.exe in it
    exit /b 1
)

rem Its version, from the file that says it, or else from Java itself.
set "E_VERSION="
for %%I in ("%E_JAVA%\..\..") do set "E_JAVA_HOME=%%~fI"
if exist "%E_JAVA_HOME%\release" (
    for /f "usebackq tokens=1,2 delims==" %%A in ("%E_JAVA_HOME%\release") do if "%%A"=="JAVA_VERSION" set "E_VERSION=%%~B"
)
if not defined E_VERSION (
    for /f "tokens=1,2* delims== " %%A in ('""%E_JAVA%" -XshowSettings:properties -version 2>&1"') do if "%%A"=="java.version" set "E_VERSION=%%B"
)
set "E_MAJOR=0"
for /f "tokens=1 delims=.-+" %%A in ("%E_VERSION%") do set "E_MAJOR=%%A"
if %E_MAJOR% LSS 17 (
    >&2 echo enlightenment: "%E_JAVA%" is Java %E_VERSION%, but Enlightenment needs 17 or newer
    exit /b 1
)

rem Short commands are over before the better of the two compilers pays for itself. In the others it compiles only what is still called
rem by the time it comes to it, and not so soon. Java 17 to 25 know these options; a newer one may do without.
set "E_COMPILER=-XX:+UnlockDiagnosticVMOptions -XX:TieredOldPercentage=10000000 -XX:Tier4InvocationThreshold=20000 -XX:Tier4MinInvocationThreshold=4000 -XX:Tier4CompileThreshold=60000"
if %E_MAJOR% GTR 25 set "E_COMPILER=%E_COMPILER% -XX:+IgnoreUnrecognizedVMOptions"
set "E_COLLECTOR=-XX:+UseParallelGC"
set "E_FIRST=%~1"
if not defined E_FIRST set "E_FIRST=help"
if "%E_FIRST:~0,1%"=="-" set "E_FIRST=help"
for %%C in (help validate inspect schema convert compare store-info completion setup) do if "%E_FIRST%"=="%%C" set "E_COMPILER=-XX:TieredStopAtLevel=1"
if "%E_COMPILER%"=="-XX:TieredStopAtLevel=1" set "E_COLLECTOR="

rem The options of the environment prevail, but Java refuses to start with two collectors of garbage, or two kinds of archives. Without their
rem quotation marks options can be compared, whatever else is in them.
set "E_GIVEN=of the environment:"
if defined JAVA_OPTS set "E_GIVEN=%E_GIVEN% %JAVA_OPTS:"=%"
if defined ENLIGHTENMENT_OPTS set "E_GIVEN=%E_GIVEN% %ENLIGHTENMENT_OPTS:"=%"
if defined JAVA_TOOL_OPTIONS set "E_GIVEN=%E_GIVEN% %JAVA_TOOL_OPTIONS:"=%"
if defined JDK_JAVA_OPTIONS set "E_GIVEN=%E_GIVEN% %JDK_JAVA_OPTIONS:"=%"
if defined _JAVA_OPTIONS set "E_GIVEN=%E_GIVEN% %_JAVA_OPTIONS:"=%"
set "E_LEFT=%E_GIVEN:+Use=%"
if not "%E_LEFT%"=="%E_GIVEN%" set "E_COLLECTOR="
set "E_LEFT=%E_GIVEN:Xshare=%"
set "E_LEFT=%E_LEFT:SharedArchiveFile=%"
set "E_LEFT=%E_LEFT:XX:AOT=%"
set "E_CHOSEN="
if not "%E_LEFT%"=="%E_GIVEN%" set "E_CHOSEN=yes"

rem The archive of classes.
set "E_ARCHIVE="
set "E_USE="
if defined LOCALAPPDATA set "E_ARCHIVE=%LOCALAPPDATA%\enlightenment\%E_PROGRAM%-java-%E_VERSION%.jsa"
if not defined E_ARCHIVE goto start
if defined E_CHOSEN goto start
if "%E_FIRST%"=="setup" goto start
if %E_MAJOR% GEQ 21 if "%E_FIRST%"=="render" if not defined ENLIGHTENMENT_NO_ARCHIVE goto create
if not exist "%E_ARCHIVE%" goto start
if %E_MAJOR% GEQ 21 goto use
rem Before version 19 Java crashes on an archive that was cut short: setup says how long it is.
set "E_SIZE="
if exist "%E_ARCHIVE%.size" set /p E_SIZE=<"%E_ARCHIVE%.size"
for %%I in ("%E_ARCHIVE%") do if not "%%~zI"=="%E_SIZE%" goto start

:use
set "E_USE=-XX:SharedArchiveFile="%E_ARCHIVE%""
goto start

:create
rem Java makes it when the first render ends; before version 21 it would forget to compile what was just then waiting for that, for good,
rem which setup prevents. It would warn on standard output of one that is of no use to it.
if not exist "%LOCALAPPDATA%\enlightenment" mkdir "%LOCALAPPDATA%\enlightenment" 2>nul
if exist "%LOCALAPPDATA%\enlightenment" set "E_USE=-XX:+AutoCreateSharedArchive -XX:+UnlockDiagnosticVMOptions -XX:-PrintWarnings -XX:SharedArchiveFile="%E_ARCHIVE%""

:start
"%E_JAVA%" %E_COMPILER% %E_COLLECTOR% %E_USE% -Xlog:disable "-Denlightenment.archive=%E_ARCHIVE%" "-Denlightenment.launcher=enlightenment" %JAVA_OPTS% %ENLIGHTENMENT_OPTS% -cp "%E_JAR%" enlightenment.cli.Main %*
exit /b %ERRORLEVEL%
