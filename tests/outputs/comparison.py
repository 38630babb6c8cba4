"""Two manifests side by side."""


def differences(before, after):
    """One line for each difference in the areas that both manifests cover."""
    areas = [area for area in before["areas"] if area in after["areas"]]
    lines = []
    for area in areas:
        ours, theirs = outputs_of(before, area), outputs_of(after, area)
        for name in sorted(ours.keys() | theirs.keys()):
            if name not in theirs:
                lines.append(f"gone     {name}")
            elif name not in ours:
                lines.append(f"new      {name}")
            elif ours[name] != theirs[name]:
                lines.append(f"changed  {name}: {told(ours[name], theirs[name])}")
    return lines


def broken_off(before, after):
    """One line for each area that was not collected to its end, which shows nothing even where both lists agree."""
    return [f"broken   {area} of {which}" for which, manifest in (("before", before), ("after", after))
            for area in manifest["broken_off"]]


def outputs_of(manifest, area):
    return {name: entry for name, entry in manifest["outputs"].items() if name.startswith(area + "/")}


def told(before, after):
    if before.get("masked") != after.get("masked"):
        return f"masked fields {before.get('masked', {})} became {after.get('masked', {})}"
    if before["bytes"] != after["bytes"]:
        return f"{before['bytes']} bytes became {after['bytes']}"
    return f"{before['bytes']} bytes, not the same ones"


def not_compared(before, after):
    """Areas that only one of the two manifests covers."""
    return sorted(set(before["areas"]) ^ set(after["areas"]))
