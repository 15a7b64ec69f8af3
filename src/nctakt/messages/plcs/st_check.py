# SPDX-License-Identifier: MIT
"""Messages about names, types and statements of Structured Text.

The numbers of the form C0032 are those of the compiler of the programming system.
"""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

_LIBRARIES = ("libraries of the project without sources", "Bibliotheken des Projekts ohne Quellen")
_OWNER = ("what it belongs to", "wozu es gehört")
_KIND = ("the type", "der Typ")
_SOURCE = ("the type of the value", "der Typ des Werts")
_TARGET = ("the type that is needed", "der verlangte Typ")

NAME_UNKNOWN = error(
    902190,
    en="{name} is not declared (C0046)",
    de="{name} ist nicht deklariert (C0046)",
    remedy_en="Did you mean {nearest}? It may be from a library without sources: {libraries}.",
    remedy_de="War {nearest} gemeint? Vielleicht aus einer Bibliothek ohne Quellen: {libraries}.",
    libraries=_LIBRARIES,
)
TYPE_UNKNOWN = error(
    902191,
    en="the type {name} is not known (C0077)",
    de="der Typ {name} ist nicht bekannt (C0077)",
    remedy_en="Did you mean {nearest}? It may be from a library without sources: {libraries}.",
    remedy_de="War {nearest} gemeint? Vielleicht aus einer Bibliothek ohne Quellen: {libraries}.",
    libraries=_LIBRARIES,
)
INTERFACE_UNKNOWN = error(
    902192,
    en="the interface {name} is not known (C0086)",
    de="die Schnittstelle {name} ist nicht bekannt (C0086)",
    remedy_en="Did you mean {nearest}? It may be from a library without sources: {libraries}.",
    remedy_de="War {nearest} gemeint? Vielleicht aus einer Bibliothek ohne Quellen: {libraries}.",
    libraries=_LIBRARIES,
)
NAME_NEEDS_QUALIFIER = error(
    902193,
    en="{name} is only known as {qualified} (C0046)",
    de="{name} ist nur als {qualified} bekannt (C0046)",
    remedy_en="Write {qualified}.",
    remedy_de="{qualified} schreiben.",
    qualified=("the name with its list or enumeration", "der Name mit Liste oder Aufzählung"),
)
NAME_AMBIGUOUS = error(
    902194,
    en="{name} is declared in several lists: {lists} (C0136)",
    de="{name} ist in mehreren Listen deklariert: {lists} (C0136)",
    remedy_en="Write the list before it.",
    remedy_de="Die Liste davor schreiben.",
    lists=("the lists", "die Listen"),
)
NAME_TWICE = error(
    902195,
    en="{name} is declared twice (C0142)",
    de="{name} ist doppelt deklariert (C0142)",
    remedy_en="Rename one of them.",
    remedy_de="Eines davon umbenennen.",
)
MEMBER_UNKNOWN = error(
    902196,
    en="{owner} has no member {name} (C0004)",
    de="{owner} hat kein Element {name} (C0004)",
    remedy_en="Did you mean {nearest}?",
    remedy_de="War {nearest} gemeint?",
    owner=_OWNER,
)
LIBRARY_MEMBER_UNKNOWN = error(
    902945,
    en="no {name} of the library {owner} is known here (C0004)",
    de="{name} der Bibliothek {owner} ist hier nicht bekannt (C0004)",
    remedy_en="Did you mean {nearest}? Otherwise add the library's source or a stub to [plc] "
    "libraries.",
    remedy_de="War {nearest} gemeint? Sonst Quelle oder Ersatz unter [plc] libraries ablegen.",
    owner=("the library", "die Bibliothek"),
)
MEMBER_NOT_ACCESSIBLE = error(
    902197,
    en="{name} of {owner} is {access} and cannot be used here (C0576)",
    de="{name} von {owner} ist {access} und hier nicht verwendbar (C0576)",
    remedy_en="Use a public method or an output.",
    remedy_de="Eine öffentliche Methode oder einen Ausgang verwenden.",
    owner=("the block that has it", "der Baustein, der es hat"),
    access=("who may use it", "wer es verwenden darf"),
)
MEMBER_REPEATED_IN_DERIVED = error(
    902198,
    en="{name} is already declared in the base (C0097)",
    de="{name} ist schon im Basistyp deklariert (C0097)",
    remedy_en="Rename it.",
    remedy_de="Umbenennen.",
)
CONSTANT_TOO_LARGE = error(
    902199,
    en="{number} does not fit {kind}: {low} … {high} (C0001)",
    de="{number} passt nicht in {kind}: {low} … {high} (C0001)",
    remedy_en="Use a larger type, or another value.",
    remedy_de="Einen größeren Typ oder einen anderen Wert verwenden.",
    kind=_KIND,
)
LITERAL_WRONG = error(
    902200,
    en="{text} is not a valid {kind}",
    de="{text} ist kein gültiger Wert: {kind}",
    remedy_en="Check how it is written.",
    remedy_de="Die Schreibweise prüfen.",
    kind=("what it should be", "was es sein soll"),
)
CHARACTER_NOT_IN_STRING = error(
    902201,
    en="{character} is not in the character set of STRING",
    de="{character} gehört nicht zum Zeichensatz von STRING",
    remedy_en="Write UTF8#'…', or use WSTRING and double quotes.",
    remedy_de="UTF8#'…' schreiben oder WSTRING mit doppelten Anführungszeichen verwenden.",
    character=("the character", "das Zeichen"),
)
STRING_CONSTANT_TOO_LONG = warning(
    902202,
    en="the string is cut off after {length} characters (C0198)",
    de="die Zeichenkette wird nach {length} Zeichen abgeschnitten (C0198)",
    remedy_en="Declare a longer STRING.",
    remedy_de="Einen längeren STRING deklarieren.",
    length=("the length of the variable", "die Länge der Variablen"),
)
CONSTANT_EXPECTED = error(
    902203,
    en="a constant is needed",
    de="hier ist eine Konstante nötig",
    remedy_en="Use a literal, or a variable of VAR CONSTANT with a constant value.",
    remedy_de="Ein Literal oder eine Variable aus VAR CONSTANT mit festem Wert verwenden.",
)
TYPE_MISMATCH = error(
    902204,
    en="{source} cannot be converted to {target} (C0032)",
    de="{source} ist nicht in {target} umwandelbar (C0032)",
    remedy_en="Convert it with a function such as TO_INT, or change the type.",
    remedy_de="Mit einer Funktion wie TO_INT umwandeln oder den Typ ändern.",
    source=_SOURCE,
    target=_TARGET,
)
SIGN_MAY_CHANGE = warning(
    902205,
    en="{source} to {target}: the sign may change (C0195)",
    de="{source} nach {target}: das Vorzeichen kann sich ändern (C0195)",
    remedy_en="Convert it with a function, or use types of one kind.",
    remedy_de="Mit einer Funktion umwandeln oder gleichartige Typen verwenden.",
    source=_SOURCE,
    target=_TARGET,
)
DIGITS_MAY_GET_LOST = warning(
    902206,
    en="{source} to {target}: digits may get lost",
    de="{source} nach {target}: Stellen können verloren gehen",
    remedy_en="Convert it with a function, or use LREAL.",
    remedy_de="Mit einer Funktion umwandeln oder LREAL verwenden.",
    source=_SOURCE,
    target=_TARGET,
)
POINTER_CONVERTED = warning(
    902207,
    en="{source} is used as {target} (C0033)",
    de="{source} wird als {target} verwendet (C0033)",
    remedy_en="Use pointers of one type, or PVOID.",
    remedy_de="Zeiger eines Typs oder PVOID verwenden.",
    source=_SOURCE,
    target=_TARGET,
)
TYPES_NOT_COMPARABLE = error(
    902208,
    en="{first} and {second} cannot be compared (C0066)",
    de="{first} und {second} sind nicht vergleichbar (C0066)",
    remedy_en="Convert one of them.",
    remedy_de="Eine Seite umwandeln.",
    first=("the left type", "der linke Typ"),
    second=("the right type", "der rechte Typ"),
)
OPERATOR_ON_WRONG_TYPES = error(
    902209,
    en="{operator} cannot be applied to {types} (C0032)",
    de="{operator} ist auf {types} nicht anwendbar (C0032)",
    remedy_en="Convert the operands.",
    remedy_de="Die Operanden umwandeln.",
    operator=("the operator", "der Operator"),
    types=("the types", "die Typen"),
)
DIVISION_BY_CONSTANT_ZERO = error(
    902210,
    en="division by zero",
    de="Division durch null",
    remedy_en="Check the divisor.",
    remedy_de="Den Divisor prüfen.",
)
POWER_REFUSED = error(
    902211,
    en="** is not known in TwinCAT",
    de="** gibt es in TwinCAT nicht",
    remedy_en="Write EXPT(x, y).",
    remedy_de="EXPT(x, y) schreiben.",
)
PRECEDENCE_UNCLEAR = warning(
    902212,
    en="XOR binds before OR here; documents disagree",
    de="XOR bindet hier vor OR; die Dokumente sind sich uneins",
    remedy_en="Write brackets.",
    remedy_de="Klammern schreiben.",
)
CONDITION_NOT_BOOL = error(
    902213,
    en="a condition is BOOL, not {kind} (C0032)",
    de="eine Bedingung ist BOOL, nicht {kind} (C0032)",
    remedy_en="Compare the value, for example with <> 0.",
    remedy_de="Den Wert vergleichen, zum Beispiel mit <> 0.",
    kind=_KIND,
)
NOT_ASSIGNABLE = error(
    902214,
    en="{name} cannot be written (C0018)",
    de="{name} ist nicht beschreibbar (C0018)",
    remedy_en="Write to a variable, an input or a property with Set.",
    remedy_de="Eine Variable, einen Eingang oder eine Eigenschaft mit Set beschreiben.",
)
REFERENCE_EXPECTED = error(
    902215,
    en="REF= binds references only",
    de="REF= bindet nur Referenzen",
    remedy_en="Declare the variable as REFERENCE TO, or write :=.",
    remedy_de="Die Variable als REFERENCE TO deklarieren oder := schreiben.",
)
REFERENCE_MISPLACED = error(
    902216,
    en="{kind} cannot be an element or target here (C0032, C0205)",
    de="{kind} ist hier nicht als Element oder Ziel möglich (C0032, C0205)",
    remedy_en="Use POINTER TO, or the type itself.",
    remedy_de="POINTER TO oder den Typ selbst verwenden.",
    kind=_KIND,
)
DEREFERENCE_OF_NO_POINTER = error(
    902217,
    en="^ needs a pointer, not {kind} (C0064)",
    de="^ braucht einen Zeiger, nicht {kind} (C0064)",
    remedy_en="Remove the ^; a reference needs none.",
    remedy_de="Das ^ entfernen; eine Referenz braucht keines.",
    kind=_KIND,
)
INDEX_OF_NO_ARRAY = error(
    902218,
    en="{kind} has no elements (C0047)",
    de="{kind} hat keine Elemente (C0047)",
    remedy_en="Remove the index.",
    remedy_de="Den Index entfernen.",
    kind=_KIND,
)
INDICES_COUNT = error(
    902219,
    en="{count} indices, but the array has {expected} dimensions",
    de="{count} Indizes, das Feld hat aber {expected} Dimensionen",
    remedy_en="Give one index for each dimension: a[i, j].",
    remedy_de="Für jede Dimension einen Index angeben: a[i, j].",
    expected=("the number of dimensions", "die Zahl der Dimensionen"),
)
INDEX_OUTSIDE = error(
    902220,
    en="index {index} is outside of {low} … {high}",
    de="Index {index} liegt außerhalb von {low} … {high}",
    remedy_en="Use an index within the bounds.",
    remedy_de="Einen Index innerhalb der Grenzen verwenden.",
)
BIT_OUTSIDE = error(
    902221,
    en="{kind} has no bit {number}: 0 … {high}",
    de="{kind} hat kein Bit {number}: 0 … {high}",
    remedy_en="Use a bit that the type has.",
    remedy_de="Ein Bit verwenden, das der Typ hat.",
    kind=_KIND,
)
THIS_OUTSIDE = error(
    902222,
    en="{word} needs a block, and for SUPER one with EXTENDS",
    de="{word} braucht einen Baustein, SUPER einen mit EXTENDS",
    remedy_en="Use it in methods, actions and bodies of blocks.",
    remedy_de="In Methoden, Aktionen und Rümpfen von Bausteinen verwenden.",
)
VALUE_EXPECTED_NOT_TYPE = error(
    902223,
    en="{name} is a type or list, not a value",
    de="{name} ist ein Typ oder eine Liste, kein Wert",
    remedy_en="Name a variable, or a value of the enumeration.",
    remedy_de="Eine Variable oder einen Wert der Aufzählung angeben.",
)
CALL_WITHOUT_BRACKETS = error(
    902224,
    en="{name} is called with brackets: {name}()",
    de="{name} wird mit Klammern aufgerufen: {name}()",
    remedy_en="Write {name}().",
    remedy_de="{name}() schreiben.",
)
FIXED_ADDRESS = error(
    902225,
    en="fixed addresses such as {text} are not supported in code",
    de="feste Adressen wie {text} werden im Code nicht unterstützt",
    remedy_en="Declare a variable: x AT %I* : BOOL.",
    remedy_de="Eine Variable deklarieren: x AT %I* : BOOL.",
)
CALL_OF_NO_UNIT = error(
    902226,
    en="{name} cannot be called (C0035)",
    de="{name} ist nicht aufrufbar (C0035)",
    remedy_en="Call a function, a method or an instance.",
    remedy_de="Eine Funktion, eine Methode oder eine Instanz aufrufen.",
)
INSTANCE_NEEDED = error(
    902227,
    en="{name} is a block and needs an instance (C0080)",
    de="{name} ist ein Baustein und braucht eine Instanz (C0080)",
    remedy_en="Declare a variable of this type, and call it.",
    remedy_de="Eine Variable dieses Typs deklarieren und sie aufrufen.",
)
CALL_OF_ABSTRACT = error(
    902228,
    en="{name} is abstract and has no body (C0511)",
    de="{name} ist abstrakt und hat keinen Rumpf (C0511)",
    remedy_en="Call the method that overrides it.",
    remedy_de="Die überschreibende Methode aufrufen.",
)
PARAMETER_UNKNOWN = error(
    902229,
    en="{owner} has no input {name} (C0044)",
    de="{owner} hat keinen Eingang {name} (C0044)",
    remedy_en="Did you mean {nearest}?",
    remedy_de="War {nearest} gemeint?",
    owner=_OWNER,
)
OUTPUT_UNKNOWN = error(
    902230,
    en="{owner} has no output {name} (C0179)",
    de="{owner} hat keinen Ausgang {name} (C0179)",
    remedy_en="Did you mean {nearest}?",
    remedy_de="War {nearest} gemeint?",
    owner=_OWNER,
)
ARGUMENT_TWICE = warning(
    902231,
    en="{name} is given twice",
    de="{name} ist doppelt angegeben",
    remedy_en="Remove one of the arguments.",
    remedy_de="Eines der Argumente entfernen.",
)
ARGUMENTS_COUNT = error(
    902232,
    en="{name} takes at most {high} arguments, and no required one may be missing (C0044)",
    de="{name} nimmt höchstens {high} Argumente, und kein nötiges darf fehlen (C0044)",
    remedy_en="Check the arguments.",
    remedy_de="Die Argumente prüfen.",
)
IN_OUT_NOT_ASSIGNED = error(
    902233,
    en="VAR_IN_OUT of {name} is missing: {names} (C0039)",
    de="VAR_IN_OUT von {name} fehlt: {names} (C0039)",
    remedy_en="Give a variable for it.",
    remedy_de="Eine Variable dafür angeben.",
    names=("the parameters", "die Parameter"),
)
VALUE_NEEDED = error(
    902234,
    en="{name} does not take {kind} (C0032)",
    de="{name} nimmt {kind} nicht an (C0032)",
    remedy_en="Convert the value.",
    remedy_de="Den Wert umwandeln.",
    kind=_KIND,
)
NO_ADDRESS = error(
    902235,
    en="{name} has no address",
    de="{name} hat keine Adresse",
    remedy_en="Use a variable; for bits use the variable that has them.",
    remedy_de="Eine Variable verwenden; bei Bits die, die sie enthält.",
)
CONSTRUCT_REFUSED = error(
    902236,
    en="{name} is not supported",
    de="{name} wird nicht unterstützt",
    remedy_en="{advice}",
    remedy_de="{advice}",
    advice=("what to do instead", "was stattdessen zu tun ist"),
)
COPY_OF_BLOCK = note(
    902237,
    en="an instance of {name} is copied byte by byte",
    de="eine Instanz von {name} wird Byte für Byte kopiert",
    remedy_en="Copy the values that are needed.",
    remedy_de="Nur die nötigen Werte kopieren.",
)
COPY_REFUSED = error(
    902238,
    en="instances of {name} must not be copied (no_copy)",
    de="Instanzen von {name} dürfen nicht kopiert werden (no_copy)",
    remedy_en="Use a reference.",
    remedy_de="Eine Referenz verwenden.",
)
CASE_OF_WRONG_TYPE = error(
    902239,
    en="CASE needs a whole number or an enumeration, not {kind}",
    de="CASE braucht eine Ganzzahl oder Aufzählung, nicht {kind}",
    remedy_en="Use IF … ELSIF.",
    remedy_de="IF … ELSIF verwenden.",
    kind=_KIND,
)
CASE_LABEL_TWICE = error(
    902240,
    en="the label {number} appears twice, or its range is empty",
    de="die Marke {number} gibt es doppelt, oder ihr Bereich ist leer",
    remedy_en="Remove one of the labels.",
    remedy_de="Eine der Marken entfernen.",
)
EXIT_OUTSIDE_LOOP = error(
    902241,
    en="{word} is outside of a loop",
    de="{word} steht außerhalb einer Schleife",
    remedy_en="Use RETURN, or IF.",
    remedy_de="RETURN oder IF verwenden.",
)
FOR_NEVER_ENDS = warning(
    902242,
    en="the loop never ends: {number} is the last value of {kind} (C0266)",
    de="die Schleife endet nie: {number} ist der letzte Wert von {kind} (C0266)",
    remedy_en="Use a larger type for the counter.",
    remedy_de="Für den Zähler einen größeren Typ verwenden.",
    kind=_KIND,
)
STEP_IS_ZERO = error(
    902243,
    en="BY 0 never ends",
    de="BY 0 endet nie",
    remedy_en="Use another step.",
    remedy_de="Eine andere Schrittweite verwenden.",
)
FOR_VARIABLE_WRITTEN = warning(
    902244,
    en="{name} counts the loop and is written in it",
    de="{name} zählt die Schleife und wird in ihr beschrieben",
    remedy_en="Use EXIT, or a WHILE loop.",
    remedy_de="EXIT oder eine WHILE-Schleife verwenden.",
)
ARRAY_BOUNDS_REVERSED = error(
    902245,
    en="the range {low}..{high} is empty or outside of its type",
    de="der Bereich {low}..{high} ist leer oder außerhalb seines Typs",
    remedy_en="Write the lower bound first.",
    remedy_de="Die untere Grenze zuerst schreiben.",
)
OPEN_ARRAY_MISPLACED = error(
    902246,
    en="ARRAY[*] is for VAR_IN_OUT only",
    de="ARRAY[*] gibt es nur für VAR_IN_OUT",
    remedy_en="Give the bounds.",
    remedy_de="Die Grenzen angeben.",
)
DATA_TOO_LARGE = error(
    902247,
    en="more than {limit} bytes of data",
    de="mehr als {limit} Byte Daten",
    remedy_en="Use smaller arrays and strings.",
    remedy_de="Kleinere Felder und Zeichenketten verwenden.",
)
DATA_CONTAIN_THEMSELVES = error(
    902248,
    en="{name} contains itself (C0101)",
    de="{name} enthält sich selbst (C0101)",
    remedy_en="Use POINTER TO.",
    remedy_de="POINTER TO verwenden.",
)
EXTENDS_ITSELF = error(
    902249,
    en="{name} extends itself (C0091)",
    de="{name} erweitert sich selbst (C0091)",
    remedy_en="Remove one EXTENDS of the circle.",
    remedy_de="Ein EXTENDS aus dem Kreis entfernen.",
)
BASE_OF_WRONG_KIND = error(
    902250,
    en="{name} cannot be extended (C0144)",
    de="{name} kann nicht erweitert werden (C0144)",
    remedy_en="A block extends a block, a structure a structure.",
    remedy_de="Ein Baustein erweitert einen Baustein, eine Struktur eine Struktur.",
)
BLOCK_BY_VALUE = warning(
    902251,
    en="the block {name} is passed by value",
    de="der Baustein {name} wird als Wert übergeben",
    remedy_en="Use VAR_IN_OUT or REFERENCE TO.",
    remedy_de="VAR_IN_OUT oder REFERENCE TO verwenden.",
)
TYPE_IS_ABSTRACT = error(
    902252,
    en="{name} is abstract and has no instances (C0177)",
    de="{name} ist abstrakt und hat keine Instanzen (C0177)",
    remedy_en="Use a derived block, or POINTER TO, REFERENCE TO or an interface.",
    remedy_de="Einen abgeleiteten Baustein oder POINTER TO, REFERENCE TO verwenden.",
)
INTERFACE_MEMBER_MISSING = error(
    902253,
    en="{name} is not implemented (C0087)",
    de="{name} ist nicht implementiert (C0087)",
    remedy_en="Add it, with Get and Set as declared.",
    remedy_de="Ergänzen, mit Get und Set wie deklariert.",
)
OVERRIDE_DIFFERS = error(
    902254,
    en="{name} has other parameters or another result than {base}",
    de="{name} hat andere Parameter oder ein anderes Ergebnis als {base}",
    remedy_en="Use the same declaration here as there.",
    remedy_de="Wie dort deklarieren.",
    base=("what it overrides", "was es überschreibt"),
)
OVERRIDE_OF_FINAL = error(
    902255,
    en="{name} is FINAL",
    de="{name} ist FINAL",
    remedy_en="Remove FINAL, or do not derive from it.",
    remedy_de="FINAL entfernen oder nicht davon ableiten.",
)
RECURSION_REFUSED = error(
    902256,
    en="{name} calls itself, directly or through others",
    de="{name} ruft sich selbst auf, direkt oder über andere",
    remedy_en="Use a loop.",
    remedy_de="Eine Schleife verwenden.",
)
PROGRAM_OF_TASK_UNKNOWN = error(
    902257,
    en="the task {task} calls {name}, which is not a program of the project",
    de="die Task {task} ruft {name} auf, das kein Programm des Projekts ist",
    remedy_en="Correct the name, or remove the call.",
    remedy_de="Den Namen berichtigen oder den Aufruf entfernen.",
    task=("the task", "die Task"),
)
ADDRESSES_OVERLAP = warning(
    902500,
    en="{name} and {other} share bits of their addresses; here each has separate memory",
    de="{name} und {other} teilen Bits ihrer Adressen; hier hat jede eigenen Speicher",
    remedy_en="Declare one of them, and read the bits of it: nStatus.3.",
    remedy_de="Eine davon deklarieren und ihre Bits lesen: nStatus.3.",
    other=("the other variable", "die andere Variable"),
)
ELEMENT_ARGUMENTS = error(
    902630,
    en="{name} has {number} elements, but arguments of FB_init for {count}",
    de="{name} hat {number} Elemente, aber Argumente von FB_init für {count}",
    remedy_en="Write a pair of brackets for each element, or one pair without [ ] for all.",
    remedy_de="Für jedes Element ein Klammerpaar schreiben, oder eines ohne [ ] für alle.",
    count=("the number of elements with arguments", "die Zahl der Elemente mit Argumenten"),
)
BIT_MISPLACED = error(
    902910,
    en="BIT is allowed only in structures and function blocks",
    de="BIT ist nur in Strukturen und Funktionsbausteinen erlaubt",
    remedy_en="Use BOOL.",
    remedy_de="BOOL verwenden.",
)
NOT_FILLED_HERE = warning(
    902968,
    en="{name} of {owner} stays empty: the NC that fills it on the machine is not simulated",
    de="{name} von {owner} bleibt leer: die NC, die es an der Maschine füllt, fehlt hier",
    remedy_en="Use positions, speeds and states of NcToPlc, Status or the MC_Read blocks.",
    remedy_de="Positionen, Geschwindigkeiten und Zustände von NcToPlc, Status oder den "
    "MC_Read-Bausteinen verwenden.",
    owner=_OWNER,
)
