//! Findings about parameters: E05xx and W05xx.

/// Hands these rows on, behind those before them.
macro_rules! parameters {
    ([$next:ident $($rest:ident)*] $($before:tt)*) => {
        $next! { [$($rest)*] $($before)*
        [E0501] ParameterNumber "parameter-number" Error {}
            en "there are parameters R0 to R95 only"
            cs "parametry jsou jen R0 až R95"
            help "use a number from 0 to 95, without sign and decimal point"
               | "použít číslo 0 až 95, bez znaménka a desetinné tečky"
        [W0502] ReservedParameter "reserved-parameter" Warning {}
            en "R95 is reserved for control functions"
            cs "R95 je vyhrazen pro řídicí funkce"
            help "use another parameter" | "použít jiný parametr"
        [W0503] UnassignedParameter "unassigned-parameter" Warning { parameter: u8, compiled: bool }
            en "R{parameter} is read before the program gives it a value"
            cs "R{parameter} se čte dřív, než mu program dal hodnotu"
            help "assign it first: `R{parameter}=…`, or give the machine's value with `--param R{parameter}=…`"
               | "nejdřív přiřadit: „R{parameter}=…“, nebo zadat hodnotu ze stroje volbou --param R{parameter}=…"
            note (if *compiled {
                "its value comes from the machine's parameter table: without it nothing is written from here on"
            } else {
                "its value comes from the machine's parameter table: what depends on it is not checked"
            })
               | (if *compiled {
                   "hodnota pochází z tabulky parametrů stroje: bez ní se od tohoto bloku nic nezapíše"
               } else {
                   "hodnota pochází z tabulky parametrů stroje: co na ní závisí, se nezkontroluje"
               })
        [W0504] AssignedAndRead "assigned-and-read" Warning { parameter: u8 }
            en "R{parameter} is read here and assigned in the same block: the old value counts"
            cs "R{parameter} se v témže bloku čte i přiřazuje: platí stará hodnota"
            help "assign it in a block before, or after" | "přiřadit ho v předchozím, nebo v následujícím bloku"
        [E0505] MissingControlWord "missing-control-word" Error { function: GCode, missing: String, reference: bool }
            en "{function} needs {missing} in its block"
            cs "{function} potřebuje v bloku {missing}"
            help ({
                let first = missing.split(',').next().sure();
                if *reference {
                    "the reference point is approached by G30".to_owned()
                } else {
                    format!(
                        "write each control word in the same block, its eight digits oo aa bb rr together: `{first}=…`"
                    )
                }
            })
               | ({
                   let first = missing.split(',').next().sure();
                   if *reference {
                       "do reference se najíždí funkcí G30".to_owned()
                   } else {
                       format!(
                           "každé řídicí slovo napsat do téhož bloku, osm číslic oo aa bb rr bez mezer: „{first}=…“"
                       )
                   }
               })
            note (if *function == GCode::G28 { "G26 to G29 compute with parameters" } else { "" })
               | (if *function == GCode::G28 { "G26 až G29 počítají s parametry" } else { "" })
        [W0506] SuperfluousControlWord "superfluous-control-word" Warning { function: GCode, parameter: u8 }
            en "{function} does not use R{parameter}"
            cs "{function} R{parameter} nepoužije"
            help "delete it, or use the function with more operations"
               | "vymazat ho, nebo použít funkci s více operacemi"
        [E0507] MalformedControlWord "malformed-control-word" Error { field: Option<i64> }
            en (match field {
                Some(number) => format!("the control word names parameter R{number}; there are R0 to R95"),
                None => "a control word is a whole number of at most eight digits".to_owned(),
            })
            cs (match field {
                Some(number) => format!("řídicí slovo uvádí parametr R{number}; jsou jen R0 až R95"),
                None => "řídicí slovo je celé číslo nejvýše o osmi číslicích".to_owned(),
            })
            help "its digits are `oo aa bb rr`: operation, first operand, second operand, result"
               | "číslice jsou „oo aa bb rr“: operace, první operand, druhý operand, výsledek"
        [E0508] UnknownOperation "unknown-operation" Error { operation: i64, digits: i64, written: usize }
            en "the configuration does not say what operation {operation:02} means"
            cs "význam kódu operace {operation:02} není v projektovém souboru uveden"
            help (if *written > 8 {
                "a control word has eight digits: `oo aa bb rr`".to_owned()
            } else {
                format!(
                    "if the control word is right, add the code to cnc872c.toml, by the machine's manual: \
                    `[operations]`, `\"{operation:02}\" = \"…\"`"
                )
            })
               | (if *written > 8 {
                   "řídicí slovo má osm číslic: „oo aa bb rr“".to_owned()
               } else {
                   format!(
                       "je-li řídicí slovo správné, doplnit kód do cnc872c.toml podle příručky stroje: [operations], \
                       \"{operation:02}\" = \"…\""
                   )
               })
            note ({
                let split = control_digits(*digits);
                if *written > 8 {
                    format!(
                        "{written} digits are written; they are read as {split}: operation, first operand, second \
                        operand, result"
                    )
                } else {
                    format!("the control word is read as {split}: operation, first operand, second operand, result")
                }
            })
               | ({
                   let split = control_digits(*digits);
                   if *written > 8 {
                       format!(
                           "je zapsáno {written} číslic; čtou se jako {split}: operace, první operand, druhý operand, \
                           výsledek"
                       )
                   } else {
                       format!("řídicí slovo se čte jako {split}: operace, první operand, druhý operand, výsledek")
                   }
               })
        [E0509] ArithmeticError "arithmetic-error" Error { what: ArithmeticFault }
            en (what.text(Lang::En))
            cs (what.text(Lang::Cs))
        [E0510] UnusableParameterValue "unusable-parameter-value" Error {
            address: Address, parameter: u8, value: String, needs: ParameterNeed,
        }
            en ({
                let needs = needs.text(*address, Lang::En);
                if value.is_empty() { needs } else { format!("R{parameter} is {value}, but {needs}") }
            })
            cs ({
                let needs = needs.text(*address, Lang::Cs);
                if value.is_empty() { needs } else { format!("R{parameter} má hodnotu {value}, ale {needs}") }
            })
        [E0511] ParameterNotAllowed "parameter-not-allowed" Error { address: Address }
            en "`{address}` takes a number, not a parameter"
            cs "za {address} musí být číslo, ne parametr"

        }
    };
}
pub(super) use parameters;
