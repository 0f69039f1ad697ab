"""What the predictions of "Translation" are held against: sums, done by hand."""
from . import Held

YES = "yes, always"
SAID = "entries are as you said"

PREDICTED = {
    "translation.sliding": [
        Held(["+-0", "000"], [(["+00", "000"], SAID), (["++0", "000"], SAID),
                              (["+0+", "000"], SAID)]),
        Held(["000", "-+0"], [(["000", "--0"], SAID), (["-+0", "000"], SAID)]),
        Held(["-+0", "000"], [(["--0", "000"], SAID), (["-0-", "000"], SAID)])],
    "translation.origin": [
        Held([2, 1, 0], [([0, 3, 0], "go back from c"), ([-1, 1, 0], "measured from frame 1")]),
        Held([-1, 1, 0], [([3, 3, 0], "go back from c"), ([2, 1, 0], "measured from frame 1")]),
        Held([1, 2, 0], [([0, 0, 0], "measured from frame 1"), ([-1, -1, 0], "x, y = 1, 2")])],
    "translation.back": [
        Held("(−2, 1)", [("(2, −1)", "look back"), ("(0, 0)", "its own origin"),
                         ("(−1, 2)", "parallel")]),
        Held("(2, −1.5)", [("(−2, 1.5)", "look back"), ("(0, 0)", "its own origin")])],
    "translation.riding": [
        Held(["+0+", "000"], [(["+-0", "000"], SAID), (["+++", "000"], SAID)]),
        Held(["000", "-0-"], [(["000", "-+0"], SAID), (["000", "---"], SAID)])],
    "translation.carried": [
        Held([0.5, 1.5, 0], [([1, 2, 0], "measured from frame 0"), ([2, 2.5, 0], "rides along"),
                             ([1.5, 2, 0], "not how far it went")]),
        Held([1.5, 0.5, 0], [([1, 2, 0], "from frame 0"), ([2.5, 1, 0], "added the slide")]),
        Held([0, 1, 0], [([1, 2, 0], "measured from frame 0"), ([1, 1.5, 0], "added the slide")])],
    "translation.rate": [
        Held(["a", "b", "c"], [(["a"], "Far away or near"), (["b", "c"], "holds for it"),
                               ([], "“c” is missing")])],
    "translation.chain": [
        Held([1, 1, 0], [([-0.5, 2, 0], "begins at frame 1"), ([2, -3, 0], "went back"),
                         ([1.5, -1, 0], "That is frame 1")]),
        Held([0, 1, 0], [([0.5, 1.5, 0], "begins at frame 1"), ([-1, -2, 0], "went back")]),
        Held([0.5, -1, 0], [([-1.5, -2, 0], "begins at frame 1"), ([2, 1, 0], "That is frame 1")])],
    "translation.order": [
        Held(YES, [("yes, but only for these numbers", "for all numbers"),
                   ("no, it ends beside it", "squared paper")])],
    "translation.height": [
        Held(2, [(4, "added, not subtracted"), (-1, "comes on top"), (5, "third component")]),
        Held(6.5, [(3.5, "not subtracted"), (1.5, "comes on top")]),
        Held(1.5, [(2.5, "not subtracted"), (-0.5, "comes on top"), (4, "along y")])],
}
