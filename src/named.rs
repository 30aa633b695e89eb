//! Values that records, options and the project file call by a word.

/// Declares an enum whose variants have names, `Rapid "rapid"`, and may have texts, `Rapid "rapid" ("G00", "G00")`.
macro_rules! named {
    (
        $(#[$attribute:meta])* $visible:vis enum $Enum:ident {
            $($(#[$of_variant:meta])* $Variant:ident $name:literal ($en:literal, $cs:literal),)*
        }
    ) => {
        $crate::named::named! {
            $(#[$attribute])* $visible enum $Enum { $($(#[$of_variant])* $Variant $name,)* }
        }

        impl $Enum {
            /// What people read.
            #[allow(dead_code, reason = "the core alone shows not all of them")]
            pub(crate) fn text(self, lang: $crate::dict::Lang) -> String {
                let text = match (self, lang) {
                    $(
                        (Self::$Variant, $crate::dict::Lang::En) => $en,
                        (Self::$Variant, $crate::dict::Lang::Cs) => $cs,
                    )*
                };
                text.to_owned()
            }
        }
    };
    (
        $(#[$attribute:meta])* $visible:vis enum $Enum:ident {
            $($(#[$of_variant:meta])* $Variant:ident $name:literal,)*
        }
    ) => {
        $(#[$attribute])*
        $visible enum $Enum {
            $($(#[$of_variant])* $Variant,)*
        }

        impl $Enum {
            /// Every one, as declared.
            $visible const ALL: [Self; [$($name),*].len()] = [$(Self::$Variant),*];

            /// What records, options and the project file call it.
            $visible const fn name(self) -> &'static str {
                match self { $(Self::$Variant => $name,)* }
            }
        }
    };
}

pub(crate) use named;
