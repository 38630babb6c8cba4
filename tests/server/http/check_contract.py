#!/usr/bin/env python3
"""check_contract.py PROTO [RECORDINGS]

Looks over PROTO/openapi.yaml and PROTO/asyncapi.yaml, and holds recorded answers and messages (JSON, one a line)
against their schemas. Every operation must have been answered well at least once. Prints what is wrong; exit code 1.
"""
import json
import re
import sys

import jsonschema
import yaml

METHODS = ("get", "put", "post", "delete", "patch", "head")


def pointer(document, reference):
    node = document
    for part in reference.removeprefix("#/").split("/"):
        node = node[part.replace("~1", "/").replace("~0", "~")]
    return node


def follow(document, node):
    return pointer(document, node["$ref"]) if "$ref" in node else node


def walk(node, place=""):
    yield place, node
    children = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ()
    for key, child in children:
        yield from walk(child, f"{place}/{key}")


def faults_of(document, schema, value):
    # With the components beside it, the schema's references lead somewhere by themselves.
    whole = {"allOf": [schema], "components": document.get("components", {})}
    validator = jsonschema.Draft202012Validator(whole)
    return [f"{'/'.join(map(str, e.absolute_path))}: {e.message[:300]}" for e in validator.iter_errors(value)]


def check_common(name, document, faults):
    """References lead somewhere, schemas are schemas, examples fit theirs, nothing lies about unused."""
    used = set()
    for place, node in walk(document):
        if not isinstance(node, dict):
            continue
        if isinstance(node.get("$ref"), str):
            try:
                pointer(document, node["$ref"])
                used.add(node["$ref"])
            except (KeyError, TypeError):
                faults.append(f"{name}{place}: {node['$ref']} leads nowhere")
        if "example" in node and isinstance(node.get("schema", node), dict) and "/properties/" not in place:
            schema = node.get("schema", node)
            for fault in faults_of(document, schema, node["example"]):
                faults.append(f"{name}{place}: example: {fault}")
    for kind, parts in document.get("components", {}).items():
        for part, value in parts.items():
            if f"#/components/{kind}/{part}" not in used:
                faults.append(f"{name}: components/{kind}/{part} is not used")
            if kind == "schemas":
                try:
                    jsonschema.Draft202012Validator.check_schema(value)
                except jsonschema.SchemaError as error:
                    faults.append(f"{name}: schemas/{part}: {error.message}")


def operations(openapi):
    for path, item in openapi["paths"].items():
        for method in METHODS:
            if method in item:
                yield path, method, item, item[method]


def check_openapi(openapi, faults):
    check_common("openapi.yaml", openapi, faults)
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
        given = [follow(openapi, p) for p in item.get("parameters", []) + operation.get("parameters", [])]
        named = {p["name"] for p in given if p["in"] == "path"}
        if named != set(re.findall(r"{(\w+)}", path)) or not all(p.get("required") for p in given if p["in"] == "path"):
            faults.append(f"{where}: path parameters do not agree with the path")
        responses = operation["responses"]
        if "default" not in responses or not any(code[0] in "123" for code in responses):
            faults.append(f"{where}: a good answer or the default is missing")
        for code, response in responses.items():
            if not follow(openapi, response).get("description"):
                faults.append(f"{where}: {code} has no description")


def check_asyncapi(asyncapi, faults):
    check_common("asyncapi.yaml", asyncapi, faults)
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


def check_answer(openapi, answer, answered, faults):
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
    content = follow(openapi, response).get("content")
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
        faults.extend(f"{where}: {fault}" for fault in faults_of(openapi, schema, json.loads(answer["body"])))


def check_message(asyncapi, text, said, faults):
    message = json.loads(text)
    name = message.get("type")
    known = asyncapi["components"]["messages"].get(name)
    if known is None:
        faults.append(f"message {name}: not described")
        return
    said.add(name)
    faults.extend(f"message {name}: {fault}" for fault in faults_of(asyncapi, known["payload"], message))


def check_recordings(openapi, asyncapi, path, faults):
    answered, said = set(), set()
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            record = json.loads(line)
            if "message" in record:
                check_message(asyncapi, record["message"], said, faults)
            else:
                check_answer(openapi, record, answered, faults)
    for described, method, _, _ in operations(openapi):
        if (described, method) not in answered:
            faults.append(f"{method.upper()} {described}: was never answered well in the recordings")
    for name in {"job", "progress", "error", "ended"} - said:
        faults.append(f"message {name}: was never sent in the recordings")


def main():
    proto = sys.argv[1]
    faults = []
    with open(f"{proto}/openapi.yaml", encoding="utf-8") as file:
        openapi = yaml.safe_load(file)
    with open(f"{proto}/asyncapi.yaml", encoding="utf-8") as file:
        asyncapi = yaml.safe_load(file)
    check_openapi(openapi, faults)
    check_asyncapi(asyncapi, faults)
    if len(sys.argv) > 2:
        check_recordings(openapi, asyncapi, sys.argv[2], faults)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
