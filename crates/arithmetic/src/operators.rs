//! One macro that gives a type its four operators, by value and by reference, from functions of two references.

/// `operators!([generics] Type, add_fn, sub_fn, mul_fn, neg_fn)`: each function takes references.
#[macro_export]
#[doc(hidden)]
macro_rules! operators {
    ([$($generics:tt)*] $type:ty, $add:expr, $sub:expr, $mul:expr, $neg:expr) => {
        $crate::operators!(@binary [$($generics)*] $type, Add, add, $add);
        $crate::operators!(@binary [$($generics)*] $type, Sub, sub, $sub);
        $crate::operators!(@binary [$($generics)*] $type, Mul, mul, $mul);
        impl<$($generics)*> std::ops::Neg for $type {
            type Output = $type;
            #[inline]
            fn neg(self) -> $type {
                let f: fn(&$type) -> $type = $neg;
                f(&self)
            }
        }
    };
    (@binary [$($generics:tt)*] $type:ty, $trait:ident, $method:ident, $function:expr) => {
        impl<$($generics)*> std::ops::$trait<&$type> for $type {
            type Output = $type;
            #[inline]
            fn $method(self, right: &$type) -> $type {
                let f: fn(&$type, &$type) -> $type = $function;
                f(&self, right)
            }
        }
        impl<$($generics)*> std::ops::$trait for $type {
            type Output = $type;
            #[inline]
            fn $method(self, right: $type) -> $type {
                let f: fn(&$type, &$type) -> $type = $function;
                f(&self, &right)
            }
        }
    };
}
pub(crate) use operators;
