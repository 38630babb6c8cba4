#!/usr/bin/env python3
"""check_contract.py PROTO [RECORDINGS]

Looks over PROTO/openapi.yaml, PROTO/asyncapi.yaml and the schemas that they refer to, and holds recorded answers and
messages (JSON, one a line) against them. Every operation must have been answered well at least once. Prints what is
wrong; exit code 1.
"""
import json
import os
import posixpath
import re
import sys

import jsonschema
import yaml

METHODS = ("get", "put", "post", "delete", "patch", "head")


def walk(node, place=""):
    yield place, node
    children = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ()
    for key, child in children:
        yield from walk(child, f"{place}/{key}")


def escaped(part):
    return part.replace("~", "~0").replace("/", "~1")


def load(folder, name, files):
    """Adds a file, and those that it refers to, to `files`, by their paths from `folder`.

    Every $ref becomes a pointer from the root of {"files": files}, so that a schema of one file can be used with all
    that it needs from the others, whatever the version of jsonschema knows of files.
    """
    if name in files:
        return
    with open(os.path.join(folder, name), encoding="utf-8") as text:
        files[name] = json.load(text) if name.endswith(".json") else yaml.safe_load(text)
    for _, node in walk(files[name]):
        if isinstance(node, dict) and isinstance(node.get("$ref"), str):
            other, _, place = node["$ref"].partition("#")
            target = posixpath.normpath(posixpath.join(posixpath.dirname(name), other)) if other else name
            load(folder, target, files)
            node["$ref"] = f"#/files/{escaped(target)}{place}"


def pointer(files, reference):
    node = {"files": files}
    for part in reference.removeprefix("#/").split("/"):
        node = node[part.replace("~1", "/").replace("~0", "~")]
    return node


def follow(files, node):
    return pointer(files, node["$ref"]) if "$ref" in node else node


def faults_of(files, schema, value):
    # With the files beside it, the schema's references lead somewhere by themselves.
    validator = jsonschema.Draft202012Validator({"allOf": [schema], "files": files})
    return [f"{'/'.join(map(str, e.absolute_path))}: {e.message[:300]}" for e in validator.iter_errors(value)]


def close_messages(files):
    """What asyncapi.yaml says in words: a message has no other members than those that are described.

    Schemas that are only parts of others (allOf) stay open.
    """
    schemas = files["asyncapi.yaml"]["components"]["schemas"]
    parts = {part.get("$ref") for schema in schemas.values() for part in schema.get("allOf", [])}
    for name, schema in schemas.items():
        if f"#/files/asyncapi.yaml/components/schemas/{name}" not in parts:
            schema["unevaluatedProperties"] = False


def check_references(files, faults):
    """References lead somewhere, and nothing lies about unused."""
    used = set()
    for name, document in files.items():
        for place, node in walk(document):
            if not isinstance(node, dict) or not isinstance(node.get("$ref"), str):
                continue
            try:
                pointer(files, node["$ref"])
                used.add(node["$ref"])
            except (KeyError, TypeError):
                faults.append(f"{name}{place}: {node['$ref']} leads nowhere")
    used |= check_security(files["openapi.yaml"], faults)
    for name, document in files.items():
        for kind, parts in {**document.get("components", {}), "$defs": document.get("$defs", {})}.items():
            folder = "$defs" if kind == "$defs" else f"components/{kind}"
            for part in parts:
                if f"#/files/{escaped(name)}/{folder}/{part}" not in used:
                    faults.append(f"{name}: {folder}/{part} is not used")


def check_security(openapi, faults):
    """The security schemes that are named; each must be described."""
    described = openapi["components"].get("securitySchemes", {})
    asked = [openapi.get("security", [])] + [o.get("security", []) for _, _, _, o in operations(openapi)]
    named = {scheme for wants in asked for want in wants for scheme in want}
    faults.extend(f"openapi.yaml: security {scheme} is not described" for scheme in named - set(described))
    return {f"#/files/{escaped('openapi.yaml')}/components/securitySchemes/{scheme}" for scheme in named}


def check_schemas(files, faults):
    """Schemas are schemas, and examples fit theirs."""
    for name, document in files.items():
        schemas = document.get("components", {}).get("schemas", {}) if name.endswith(".yaml") else {"": document}
        for part, schema in schemas.items():
            try:
                jsonschema.Draft202012Validator.check_schema(schema)
            except jsonschema.SchemaError as error:
                faults.append(f"{name}: {part}: {error.message}")
        for place, node in walk(document):
            if isinstance(node, dict) and "example" in node and "/properties/" not in place:
                schema = node.get("schema", node)
                faults.extend(f"{name}{place}: example: {fault}" for fault in faults_of(files, schema, node["example"]))


def operations(openapi):
    for path, item in openapi["paths"].items():
        for method in METHODS:
            if method in item:
                yield path, method, item, item[method]


def check_openapi(files, faults):
    openapi = files["openapi.yaml"]
    if not openapi["openapi"].startswith("3.1"):
        faults.append("openapi.yaml: not 3.1")
    ids, tags = set(), {tag["name"] for tag in openapi["tags"]}
    for path, method, item, operation in operations(openapi):
        where = f"openapi.yaml: {method.upper()} {path}"
        if operation.get("operationId", "") in ids or not operation.get("operationId"):
            faults.append(f"{where}: operationId missing or not unique")
        ids.add(operation.get("operationId"))
        if not operation.get("summary") or not set(operation.get("tags", [])) <= tags or not operation.get("tags"):
            faults.append(f"{where}: summary or a declared tag is missing")
        given = [follow(files, p) for p in item.get("parameters", []) + operation.get("parameters", [])]
        named = {p["name"] for p in given if p["in"] == "path"}
        if named != set(re.findall(r"{(\w+)}", path)) or not all(p.get("required") for p in given if p["in"] == "path"):
            faults.append(f"{where}: path parameters do not agree with the path")
        responses = operation["responses"]
        if "default" not in responses or not any(code[0] in "123" for code in responses):
            faults.append(f"{where}: a good answer or the default is missing")
        for code, response in responses.items():
            if not follow(files, response).get("description"):
                faults.append(f"{where}: {code} has no description")


def check_asyncapi(asyncapi, faults):
    if not asyncapi["asyncapi"].startswith("3.0"):
        faults.append("asyncapi.yaml: not 3.0")
    for name, channel in asyncapi["channels"].items():
        if set(channel.get("parameters", {})) != set(re.findall(r"{(\w+)}", channel["address"])):
            faults.append(f"asyncapi.yaml: {name}: parameters do not agree with the address")
    spoken = {m["$ref"].rsplit("/", 1)[1] for o in asyncapi["operations"].values() for m in o["messages"]}
    if spoken != {m for c in asyncapi["channels"].values() for m in c["messages"]}:
        faults.append("asyncapi.yaml: a message belongs to no operation")
    for operation in asyncapi["operations"].values():
        if operation.get("action") not in ("send", "receive"):
            faults.append("asyncapi.yaml: an operation neither sends nor receives")


def matching(openapi, path):
    """The path of the description that `path` is an instance of; fixed parts before braces."""
    for known in sorted(openapi["paths"], key=lambda p: p.count("{")):
        if re.fullmatch(re.sub(r"{\w+}", "[^/]+", known), path):
            return known
    return None


def check_answer(files, answer, answered, faults):
    openapi = files["openapi.yaml"]
    where = f"{answer['method']} {answer['path']} -> {int(answer['status'])}"
    path = matching(openapi, answer["path"])
    operation = openapi["paths"].get(path, {}).get(answer["method"].lower())
    if operation is None:
        faults.append(f"{where}: not described")
        return
    code = str(int(answer["status"]))
    response = operation["responses"].get(code)
    if response is None:
        faults.append(f"{where}: this status is not described")
        return
    if code[0] in "12":
        answered.add((path, answer["method"].lower()))
    content = follow(files, response).get("content")
    media = answer["content_type"].split(";")[0]
    if not content:
        if media:
            faults.append(f"{where}: has a body, and none is described")
        return
    if media not in content:
        faults.append(f"{where}: {media} is not described")
        return
    schema = content[media].get("schema")
    if schema is not None and "json" in media:
        faults.extend(f"{where}: {fault}" for fault in faults_of(files, schema, json.loads(answer["body"])))


def check_message(files, text, said, faults):
    message = json.loads(text)
    name = message.get("type")
    known = files["asyncapi.yaml"]["components"]["messages"].get(name)
    if known is None:
        faults.append(f"message {name}: not described")
        return
    said.add(name)
    faults.extend(f"message {name}: {fault}" for fault in faults_of(files, known["payload"], message))


def check_recordings(files, path, faults):
    answered, said = set(), set()
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            record = json.loads(line)
            if "message" in record:
                check_message(files, record["message"], said, faults)
            else:
                check_answer(files, record, answered, faults)
    for described, method, _, _ in operations(files["openapi.yaml"]):
        if (described, method) not in answered:
            faults.append(f"{method.upper()} {described}: was never answered well in the recordings")
    for name in {"job", "progress", "error", "ended"} - said:
        faults.append(f"message {name}: was never sent in the recordings")


def main():
    files, faults = {}, []
    for name in ("openapi.yaml", "asyncapi.yaml"):
        load(sys.argv[1], name, files)
    close_messages(files)
    check_references(files, faults)
    check_schemas(files, faults)
    check_openapi(files, faults)
    check_asyncapi(files["asyncapi.yaml"], faults)
    if len(sys.argv) > 2:
        check_recordings(files, sys.argv[2], faults)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
