//! How each G function is written, an example, and what follows from other functions: the part of its page that tables
//! do not give. The examples are executed by a test.

use crate::dict::{Bilingual, GCode};

use GCode::*;

/// The common parts of the pages of functions.
#[derive(Clone, Copy, Debug)]
pub(super) struct Usage<C: 'static> {
    /// The functions.
    pub(super) codes: &'static [C],
    /// How a block with it is written; `…` marks a value.
    pub(super) syntax: &'static str,
    /// Blocks of a program. Where no block ends it, M30 is added to execute it.
    pub(super) example: &'static str,
    /// The project file of the example.
    pub(super) project: &'static str,
    /// What else there is to know.
    pub(super) notes: &'static [Bilingual],
}

pub(super) const fn usage<C>(
    codes: &'static [C],
    syntax: &'static str,
    example: &'static str,
    notes: &'static [Bilingual],
) -> Usage<C> {
    Usage { codes, syntax, example, project: "", notes }
}

pub(super) const fn note(en: &'static str, cs: &'static str) -> Bilingual {
    Bilingual { en, cs }
}

const ARC: &[Bilingual] = &[
    note(
        "X, Y, Z: the end point, under G91 the distance to it. Without any of them: a full circle in the plane in \
        force",
        "X, Y, Z: koncový bod, při G91 vzdálenost k němu. Bez nich: celá kružnice v platné rovině",
    ),
    note(
        "I, J: the distance from the start of the arc to its centre, never a coordinate, under G90 too. I belongs to \
         the first of the two axes in the order of the machine, J to the second: in G19 I is along X, J along Z. One \
         that is missing is 0",
        "I, J: vzdálenost středu od začátku oblouku, nikdy souřadnice, ani při G90. I patří k té z obou os, která je \
         ve stroji první, J ke druhé: v G19 je I ve směru X, J ve směru Z. Chybějící je 0",
    ),
    note(
        "There is no radius: R is a parameter. K has no use in an arc",
        "Poloměr se nezadává: R je parametr. K v oblouku nemá význam",
    ),
    note(
        "Two axis words choose the plane themselves; with one or none it is that of G17, G18 (YZ!), G19 (ZX!), G14, \
         G15, G16. A third axis word makes a helix: with G09",
        "Dvě slova os rovinu určují sama; s jedním nebo žádným platí rovina podle G17, G18 (YZ!), G19 (ZX!), G14, G15, \
         G16. Třetí slovo osy dělá šroubovici: s G09",
    ),
    note(
        "Seen with the first axis of the plane to the right and the second up (XY, YZ, ZX), G02 turns clockwise, G03 \
         counter-clockwise",
        "Při pohledu, kde první osa roviny míří vpravo a druhá nahoru (XY, YZ, ZX), jede G02 ve směru hodinových \
         ručiček, G03 proti němu",
    ),
    note(
        "The function holds: a block with axis words and without a G00, G01 … is an arc again, and needs I and J of \
         its own",
        "Funkce platí dál: i další blok se slovy os bez G00, G01 … je oblouk a potřebuje vlastní I a J",
    ),
    note(
        "Under G74 the X of the end point is a diameter, I and J are radii",
        "Při G74 je X koncového bodu průměr, I a J jsou poloměry",
    ),
];

const ARITHMETIC: &[Bilingual] = &[
    note(
        "G26 does one operation, by R5; G27 two, by R5 and R6; G28 three, G29 four, up to R8. These words are in the \
         same block",
        "G26 provede jednu operaci podle R5, G27 dvě podle R5 a R6, G28 tři, G29 čtyři až podle R8. Tato slova jsou v \
         témž bloku",
    ),
    note(
        "A control word is eight digits, `oo aa bb rr`: the operation, the parameters of its two operands, the \
         parameter that receives the result. 01 10 11 12: operation 01 with R10 and R11, result in R12. Zeros at the \
         front may be left out",
        "Řídicí slovo má osm číslic „oo aa bb rr“: operace, parametry obou operandů, parametr pro výsledek. 01 10 11 \
         12: operace 01 s R10 a R11, výsledek do R12. Úvodní nuly lze vynechat",
    ),
    note("With `-` before it, it computes in whole numbers", "Se znaménkem - se počítá v celých číslech"),
    note(
        "Which number is which operation the project file says, under `[operations]`; without it nothing is guessed \
        (E0508)",
        "Která operace má které číslo, určuje projektový soubor v části `[operations]`; bez ní se nic nehádá (E0508)",
    ),
    note(
        "Words of the block read the parameters from before it: what it computes is used by the next block",
        "Slova bloku čtou parametry z doby před ním: výsledek použije až další blok",
    ),
];

const fn arithmetic(codes: &'static [GCode], syntax: &'static str, example: &'static str) -> Usage<GCode> {
    Usage { project: "[operations]\n\"01\" = \"add\"\n\"02\" = \"mul\"\n", ..usage(codes, syntax, example, ARITHMETIC) }
}

const CYCLE: &[Bilingual] = &[
    note(
        "On other controls these cycles drill, tap and bore (G81 drilling, G84 tapping, G85 boring)",
        "U jiných systémů tyto cykly vrtají, řežou závity a vyvrtávají (G81 vrtání, G84 závit, G85 vyvrtávání)",
    ),
    note(
        "Of what it does the manuals say only \"by the ISO standard\". So the project file says which macrocycle \
         it is: `[cycles]`, `G81 = 8100`",
        "O tom, co dělá, říkají příručky systému jen „podle normy ISO“. Makrocyklus proto určuje projektový soubor: \
         `[cycles]`, `G81 = 8100`",
    ),
    note(
        "While it holds, each block with a motion moves as G00, G01 … require, and then calls the macrocycle once, as \
         a G72 would. G80 ends it",
        "Dokud platí, každý blok s pohybem jede podle G00, G01 … a pak jednou zavolá makrocyklus, jako by to udělala \
         G72. Ukončí ji G80",
    ),
    note(
        "Without `[cycles]` nothing is invented: W0612, the block has no motion, and its axes are unknown after it",
        "Bez `[cycles]` se nic nevymýšlí: W0612, blok nemá pohyb a polohy jeho os pak nejsou známé",
    ),
    note(
        "A block cannot both call by the cycle and hold G71, G72 or G73",
        "V bloku, který volá cyklus, nesmí být G71, G72 ani G73",
    ),
];

const CYCLE_PROJECT: &str = "[cycles]\nG81 = 8100\n";

const OFFSET: &[Bilingual] = &[
    note(
        "The origins are in the control's table; programs are checked in programmed coordinates, without them",
        "Počátky jsou v tabulce systému; programy se kontrolují v programovaných souřadnicích, bez nich",
    ),
    note(
        "After a change the tool is not where the program expects it: go to the next point by a straight line, not by \
         an arc (W0610)",
        "Po změně nástroj nestojí tam, kde předpokládá program: další bod najet přímkou, ne obloukem (W0610)",
    ),
];

const PLANE: &[Bilingual] = &[
    note(
        "G17 is XY, G18 is YZ, G19 is ZX: G18 and G19 are the other way round than in ISO 6983, so a lathe with X and \
         Z needs G19",
        "G17 je XY, G18 je YZ, G19 je ZX: G18 a G19 jsou oproti ISO 6983 prohozené, soustruh s osami X a Z tedy \
         potřebuje G19",
    ),
    note(
        "G14, G15, G16 have the 4th axis in them: the first of the machine that is not X, Y, Z",
        "G14, G15, G16 mají v rovině 4. osu: první osu stroje, která není X, Y ani Z",
    ),
    note(
        "The plane serves G41 and G42, and arcs with fewer than two axis words",
        "Rovina slouží pro G41 a G42 a pro oblouky s méně než dvěma slovy os",
    ),
];

const FEED_MODE: &[Bilingual] = &[
    note(
        "A new F belongs to it: the number of the old one has another unit (W0615)",
        "Patří k ní nové F: číslo předchozího má jinou jednotku (W0615)",
    ),
    note(
        "G94 and G96: mm/min; G95: mm/rev, with S. G97 by key `g97`: mm/min on CNC872, mm/rev with constant cutting \
         speed on CNC8x6 and CNC8x9",
        "G94 a G96: mm/min; G95: mm/ot, s S. G97 podle klíče `g97`: mm/min u CNC872, mm/ot s konstantní řeznou \
         rychlostí u CNC8x6 a CNC8x9",
    ),
];

const TRANSFORMATION: &[Bilingual] = &[
    note(
        "The axis words and I, J, K of its block are its data: nothing moves, and they are in the stream as written",
        "Slova os a I, J, K v jejím bloku jsou její údaje: nic nejede, v proudu bloků jsou tak, jak jsou napsána",
    ),
    note(
        "G34 ends it. After a change the first motion is a straight line (W0610)",
        "Zruší ji G34. Po změně má být první pohyb přímkový (W0610)",
    ),
];

const COPYING: &[Bilingual] = &[note(
    "Its effect is not modelled (W0612): the stream shows the programmed path",
    "Účinek se nemodeluje (W0612): proud bloků ukazuje programovanou dráhu",
)];

const HELIX: &[Bilingual] = &[
    note(
        "G09 with an arc and a third axis makes a helix; without G09 that is W0613",
        "G09 s obloukem a třetí osou dělá šroubovici; bez G09 je to W0613",
    ),
    note(
        "I, J, K beside the arc's go into the stream as written: the manuals do not say which of them gives the pitch",
        "I, J, K jsou v proudu bloků tak, jak jsou napsána: příručky systému neříkají, které z nich udává stoupání",
    ),
    note("They hold until G98, G23 or G24", "Platí do G98, G23 nebo G24"),
];

/// The comments of the examples; in Czech without diacritics, as in programs.
pub(super) const COMMENTS: &[Bilingual] = &[
    note("half a second", "pul sekundy"),
    note("turn the part", "otocit obrobek"),
    note("in this block only", "jen v tomto bloku"),
    note("N20 runs four times", "N20 probehne ctyrikrat"),
    note("at X15", "na X15"),
];

/// Every G function, in groups that are written alike.
pub(super) const USAGES: &[Usage<GCode>] = &[
    usage(
        &[G00],
        "G00 X… Y… Z…",
        "N10 G90 G00 X50 Y20 Z5",
        &[
            note("F has no part in it", "F se neuplatní"),
            note(
                "The targets count by G90 or G91; under G74 X is a diameter",
                "Cíle platí podle G90 nebo G91; při G74 je X průměr",
            ),
        ],
    ),
    usage(
        &[G01],
        "G01 X… Y… Z… F…",
        "N10 G90 G00 X0 Y0 Z2\nN20 G01 Z-3 F100\nN30 X40 F300",
        &[
            note(
                "F holds until the next one; without any: W0601. Its unit is that of G94 to G97",
                "F platí do dalšího; bez něj: W0601. Jednotku určují G94 až G97",
            ),
            note(
                "With linear and rotary axes together F belongs to the linear ones",
                "Jedou-li spolu lineární a rotační osy, patří F k lineárním",
            ),
        ],
    ),
    usage(&[G02], "G02 X… Y… I… J… F…", "N10 G90 G17 G00 X0 Y0\nN20 G01 X10 Y20 F200\nN30 G02 X30 Y0 I0 J-20", ARC),
    usage(&[G03], "G03 X… Y… I… J… F…", "N10 G90 G17 G00 X30 Y0\nN20 G03 X10 Y20 I-20 J0 F200", ARC),
    usage(
        &[G30],
        "G30 X… Y… Z…",
        "N10 G30 Z0\nN20 G30 X0 Y0",
        &[
            note(
                "The words only name the axes, their values are not used. Afterwards the positions of these axes are \
                 unknown: program them under G90 next",
                "Slova jen určují osy, jejich hodnoty se nepoužijí. Polohy těchto os pak nejsou známé: nejdřív je \
                zadat při G90",
            ),
            note(
                "It holds in its block only; G00, G01 … go on after it",
                "Platí jen ve svém bloku; G00, G01 … platí pak dál",
            ),
        ],
    ),
    usage(
        &[G33],
        "G33 Z… K… F…",
        "N10 G95 S400 M03\nN20 G90 G00 X0 Z2\nN30 G33 Z-20 F1.5",
        &[
            note(
                "F counts by the G6 function in force; under G95 it is the path per revolution, and S must be in \
                force (W0604)",
                "F platí podle funkce skupiny G6; při G95 je to dráha na otáčku a musí platit S (W0604)",
            ),
            note(
                "I, J, K go into the stream as written: the manuals do not say which of them gives a pitch",
                "I, J, K jsou v proudu bloků tak, jak jsou napsána: příručky systému neříkají, které z nich udává \
                stoupání",
            ),
        ],
    ),
    usage(&[G17, G18, G19, G14, G15, G16], "G17", "N10 G17 G90 G00 X0 Y0\nN20 G19 Z5", PLANE),
    usage(&[G05, G06, G07, G08], "G05", "N10 G05 G90 G00 X0\nN20 G98", COPYING),
    usage(
        &[G09],
        "G09 G02 X… Y… Z… I… J… K…",
        "N10 G90 G00 X20 Y0 Z0\nN20 G09 G03 X20 Y0 Z-2 I-20 J0 F100\nN30 G98",
        HELIX,
    ),
    usage(&[G10], "G10 G02 X… Y… I… J… K…", "N10 G90 G00 X20 Y0\nN20 G10 G03 X20 Y0 I-20 J0 F100\nN30 G98", HELIX),
    usage(
        &[G23],
        "G23 I…",
        "N10 G23 I1 G90 G01 X0 F500\nN20 X10\nN30 Y10",
        &[
            note(
                "I 1 to 4 chooses a dynamic set, when G23 is in the block and the block is no arc; it stays until the \
                 next G23 with I",
                "I 1 až 4 volí sadu dynamiky, je-li G23 v bloku a blok není oblouk; platí do další G23 s I",
            ),
            note(
                "M functions with BreakCont or BreakContEnd, G04, M00 and G00 break the continuous path all the same",
                "M funkce s BreakCont nebo BreakContEnd, G04, M00 a G00 plynulou návaznost přesto přeruší",
            ),
        ],
    ),
    usage(
        &[G24, G98],
        "G24",
        "N10 G24 G90 G01 X0 F500\nN20 X10\nN30 G98",
        &[note(
            "Every block begins and ends with a ramp; for a continuous path G23",
            "Každý blok začíná a končí rampou; pro plynulou dráhu G23",
        )],
    ),
    usage(
        &[G40],
        "G40",
        "N10 T1 M06\nN20 S1000 M03\nN30 G90 G17 G00 X-20 Y0 D1\nN40 G41 G01 X0 Y0 F200\nN50 X50\nN60 G40 X70",
        &[note(
            "Begin and end the correction on a straight motion (W0624); end it before M06 and the end of the program \
            (W0625)",
            "Korekci začít a ukončit na přímkovém pohybu (W0624); před M06 a koncem programu ji ukončit (W0625)",
        )],
    ),
    usage(
        &[G41, G42],
        "G41 D…",
        "N10 T1 M06\nN20 S1000 M03\nN30 G90 G17 G00 X-20 Y0 D1\nN40 G41 G01 X0 Y0 F200\nN50 X50\nN60 G40 X70",
        &[
            note(
                "D chooses the radius in the control's table; without a D in force: W0618",
                "D vybírá poloměr z tabulky systému; neplatí-li žádné D: W0618",
            ),
            note(
                "Left and right are seen in the direction of motion, in the plane of G17, G18, G19",
                "Vlevo a vpravo je po směru pohybu, v rovině podle G17, G18, G19",
            ),
            note(
                "The stream has the programmed path; the correction is a state for whoever applies it",
                "V proudu bloků je programovaná dráha; korekce je stav pro toho, kdo ji uplatní",
            ),
        ],
    ),
    arithmetic(&[G26], "G26 R5=ooaabbrr", "N10 R10=12.5 R11=4\nN20 G26 R5=01101112\nN30 G90 G00 XR12 \"16.5\""),
    arithmetic(
        &[G27],
        "G27 R5=ooaabbrr R6=ooaabbrr",
        "N10 R10=12.5 R11=4\nN20 G27 R5=01101112 R6=02121113\nN30 G90 G00 XR13 \"66\"",
    ),
    arithmetic(
        &[G28],
        "G28 R5=ooaabbrr R6=ooaabbrr R7=ooaabbrr",
        "N10 R10=12.5 R11=4\nN20 G28 R5=01101112 R6=02121113 R7=01131014\nN30 G90 G00 XR14 \"78.5\"",
    ),
    arithmetic(
        &[G29],
        "G29 R5=ooaabbrr R6=ooaabbrr R7=ooaabbrr R8=ooaabbrr",
        "N10 R10=12.5 R11=4\nN20 G29 R5=01101112 R6=02121113 R7=01131014 R8=01141115\nN30 G90 G00 XR15 \"82.5\"",
    ),
    usage(&[G53, G54, G55, G56, G57], "G54", "N10 G54 G90 G00 X0 Y0", OFFSET),
    usage(&[G58, G59], "G58", "N10 G54 G90 G00 X0 Y0\nN20 G58 X5 \"in this block only\"\nN30 X10", OFFSET),
    usage(&[G94], "G94 F…", "N10 G94 G90 G01 X10 F300", FEED_MODE),
    usage(&[G95], "G95 S… F…", "N10 G95 S800 M03\nN20 G90 G01 X10 F0.2", FEED_MODE),
    usage(&[G96], "G96 S… F…", "N10 G96 S120 M03\nN20 G90 G01 X10 F200", FEED_MODE),
    usage(&[G97], "G97 S… F…", "N10 G97 S800 M03\nN20 G90 G00 X10", FEED_MODE),
    usage(
        &[G70, G79],
        "G79 L… … G70",
        "N10 G90 G00 X0 Y0\nN20 G71 L100\nN30 M30\nN40 G79 L100\nN50 G91 G01 X5 F200\nN60 G90 G70",
        &[
            note(
                "A subprogram begins with a block that holds its number, G79, L and nothing else, and ends with the \
         first block that holds G70; that block may do more",
                "Podprogram začíná blokem, ve kterém je jen jeho číslo, G79 a L, a končí prvním blokem s G70; ten \
         může dělat i něco dalšího",
            ),
            note(
                "It comes after M02 or M30, in the file of its program; a macrocycle is one such unit in a file of \
        its own",
                "Je za M02 nebo M30 v souboru svého programu; makrocyklus je jeden takový celek ve vlastním souboru",
            ),
        ],
    ),
    usage(
        &[G71],
        "G71 L… Q…",
        "N10 G90 G00 X0 Y0\nN20 G71 L100 Q3\nN30 M30\nN40 G79 L100\nN50 G91 G01 X5 F200\nN60 G90 G70",
        &[
            note(
                "L: the number after G79; Q: how many times, once without it. With G04 in the block Q is the dwell",
                "L: číslo za G79; Q: kolikrát, bez něj jednou. S G04 v bloku je Q prodleva",
            ),
            note(
                "The call comes at the end of its block, after its motion. Functions and parameters stay as the \
                 subprogram leaves them",
                "Volání je až na konci bloku, po jeho pohybu. Funkce a parametry zůstanou, jak je podprogram nechá",
            ),
            note(
                "G71 is no choice of millimetres here, and no turning cycle",
                "G71 zde není volba milimetrů ani soustružnický cyklus",
            ),
        ],
    ),
    usage(
        &[G72],
        "G72 L… Q…",
        "N10 R10=5\nN20 G72 L8100 Q2",
        &[
            note(
                "The macrocycle is a file `L8100` (also .NC, .NCP, .MRC, .TXT) in the program's folder, or in those of \
                 `macrocycles` and -L. Values are given to it in parameters",
                "Makrocyklus je soubor `L8100` (i .NC, .NCP, .MRC, .TXT) ve složce programu, nebo ve složkách podle \
                 `macrocycles` a -L. Hodnoty se předávají v parametrech",
            ),
            note(
                "The call comes at the end of its block. With G04 in the block Q is the dwell",
                "Volání je až na konci bloku. S G04 v bloku je Q prodleva",
            ),
        ],
    ),
    usage(
        &[G73],
        "G73 L… Q…",
        "N10 G90 G00 X0 Y0\nN20 G91 G01 X5 F200\nN30 G73 L20 Q3 \"N20 runs four times\"\nN40 G90",
        &[
            note(
                "L is a block number of the same unit, N1 to N9999. Q is the number of jumps: going back, the stretch \
                 runs Q + 1 times",
                "L je číslo bloku téhož celku, N1 až N9999. Q je počet skoků: při skoku zpět proběhne úsek Q + 1krát",
            ),
            note(
                "Without Q a jump back is taken once, a jump forward always. There are no conditions",
                "Bez Q se skok zpět provede jednou, skok vpřed vždy. Podmínky nejsou",
            ),
            note(
                "Each G73 has its counter: an inner loop runs in full in every pass of the outer one",
                "Každá G73 má své počítadlo: vnitřní smyčka proběhne celá v každém průchodu vnější",
            ),
        ],
    ),
    usage(&[G80], "G80", "N10 G80 G90 G00 X0", &[note("Ends G81 to G89", "Ukončí G81 až G89")]),
    Usage {
        project: CYCLE_PROJECT,
        ..usage(
            &[G81, G82, G83, G84, G85, G86, G87, G88, G89],
            "G81 X… Y…",
            "N10 R10=-5\nN20 G81 G90 G00 X10 Y10\nN30 X20\nN40 G80 X0 Y0",
            CYCLE,
        )
    },
    usage(
        &[G90, G91],
        "G90 X… Y… Z…",
        "N10 G90 G00 X10 Y10\nN20 G91 X5 \"at X15\"\nN30 G90",
        &[
            note(
                "G90: words are targets. G91: distances from where the axis is; begin with G90, or the position is \
                 unknown (W0605)",
                "G90: slova jsou cíle. G91: vzdálenosti od místa, kde osa je; začít G90, jinak poloha není známá \
                (W0605)",
            ),
            note(
                "They hold across calls: a subprogram with G91 ends with G90",
                "Platí i přes volání: podprogram s G91 má končit s G90",
            ),
        ],
    ),
    usage(
        &[G04],
        "G04 Q…",
        "N10 G04 Q50 \"half a second\"",
        &[
            note("Q: a whole number of 10 ms, 0 to 9999", "Q: celé číslo po 10 ms, 0 až 9999"),
            note(
                "A motion in the same block comes first, the dwell after it",
                "Pohyb v témž bloku je první, prodleva po něm",
            ),
        ],
    ),
    usage(
        &[G92],
        "G92 G54 X… Y… Z…",
        "N10 G92 G54 X100 Y50\nN20 G92 D1 X5",
        &[
            note(
                "With a G5 function it writes origins, with D entries of the correction table. Nothing moves; the \
                 words are data",
                "S funkcí skupiny G5 zapisuje počátky, s D položky tabulky korekcí. Nic nejede; slova jsou údaje",
            ),
            note("The next motion is a straight line (W0610)", "Další pohyb má být přímkový (W0610)"),
        ],
    ),
    usage(
        &[G93],
        "G93 X… Y… Z…",
        "N10 G90 G00 X10 Y10\nN20 G93 G54 X0 Y0\nN30 G01 X5 F200",
        &[note(
            "Writes the origin so that the tool stands at the programmed coordinates; nothing moves. The named axes \
             are known afterwards",
            "Zapíše počátek tak, aby nástroj stál na programovaných souřadnicích; nic nejede. Polohy uvedených os \
             jsou pak známé",
        )],
    ),
    usage(
        &[G74, G75],
        "G74 X…",
        "N10 G74 G90 G00 X50 Z2\nN20 G01 X40 Z-10 F100\nN30 G75",
        &[
            note(
                "G74: X words are diameters, absolute and incremental; I and J stay radii. The stream has radii",
                "G74: slova X jsou průměry, absolutně i přírůstkově; I a J zůstávají poloměry. V proudu bloků jsou \
                poloměry",
            ),
            note("G75: X words are radii", "G75: slova X jsou poloměry"),
        ],
    ),
    usage(&[G34], "G34", "N10 G34 G90 G00 X0", &[note("Ends G31 and G35 to G39", "Zruší G31 a G35 až G39")]),
    usage(&[G35], "G35 X…", "N10 G90 G00 X0 Y0\nN20 G35 X1\nN30 G00 X10\nN40 G34\nN50 G00 X0", TRANSFORMATION),
    usage(&[G36], "G36 X…", "N10 G90 G00 X0 Y0\nN20 G36 X2\nN30 G00 X10\nN40 G34\nN50 G00 X0", TRANSFORMATION),
    usage(&[G37], "G37 X… Y…", "N10 G90 G00 X0 Y0\nN20 G37 X5 Y5\nN30 G00 X10\nN40 G34\nN50 G00 X0", TRANSFORMATION),
    usage(&[G38], "G38 X…", "N10 G90 G00 X0 Y0\nN20 G38 X30\nN30 G00 X10\nN40 G34\nN50 G00 X0", TRANSFORMATION),
    usage(&[G39], "G39 X…", "N10 G90 G00 X0 Y0\nN20 G39 X30\nN30 G00 X10\nN40 G34\nN50 G00 X0", TRANSFORMATION),
    usage(
        &[G31],
        "G31 X… Y… Z…",
        "N10 G90 G00 X0 Y0\nN20 G31 X30 Y0 Z0\nN30 G00 X10\nN40 G34\nN50 G00 X0",
        TRANSFORMATION,
    ),
];

/// The notes on a function beyond the tables.
pub(super) fn of(code: GCode) -> Option<&'static Usage<GCode>> {
    USAGES.iter().find(|usage| usage.codes.contains(&code))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dict::{Dialect, standard_m_functions};
    use crate::explain::m_usage;

    /// Each comment with words is there in Czech too.
    #[test]
    fn comments_are_translated() {
        let examples = USAGES.iter().map(|usage| usage.example);
        for example in examples.chain(m_usage::USAGES.iter().map(|usage| usage.example)) {
            for comment in example.split('"').skip(1).step_by(2).filter(|text| text.contains(char::is_alphabetic)) {
                assert!(COMMENTS.iter().any(|known| known.en == comment), "{comment}");
            }
        }
    }

    /// Each function has its syntax and example, once.
    #[test]
    fn every_function_has_a_usage() {
        for code in GCode::ALL {
            assert_eq!(USAGES.iter().filter(|usage| usage.codes.contains(code)).count(), 1, "{code}");
        }
        for number in Dialect::ALL.into_iter().flat_map(standard_m_functions).map(|row| row.number) {
            assert_eq!(m_usage::USAGES.iter().filter(|usage| usage.codes.contains(&number)).count(), 1, "M{number}");
        }
    }
}
