#!/usr/bin/python3
"""Joins what several processes of one benchmark wrote as JSON: docs/join_benches.py FILE… >ALL.json"""
import json
import sys

results = [json.load(open(path, encoding="utf-8")) for path in sys.argv[1:]]
joined = results[0]
joined["benchmarks"] = [run for result in results for run in result["benchmarks"]]
json.dump(joined, sys.stdout, indent=1)
