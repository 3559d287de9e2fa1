"""tripus check: certificates of "infeasible", from the answers of solve."""

import json

from support import TRIPUS, ProgramTest, read_json

INFEASIBLE = "dLQbcbcaekw"  # data/nongeometric-3.tsv


class Check(ProgramTest):
    def setUp(self):
        super().setUp()
        answer = self.run_program("solve", INFEASIBLE, "--json")
        self.assertEqual(answer.status, 1)
        self.write("answer", answer.out)
        self.certificate = read_json(answer.text)["certificate"]

    def test_accepts_what_solve_gave(self):
        self.write("certificate", json.dumps(self.certificate))
        for given in ("answer", "certificate"):
            answer = self.json_answer("check", given, INFEASIBLE)
            self.assertEqual(list(answer), ["tripus", "input", "kind", "valid", "message"])
            self.assertIs(answer["valid"], True)
            self.assertIn("valid", self.run_program("check", given, INFEASIBLE).text)

    def test_accepts_both_from_standard_input_in_turn(self):
        with open(self.folder / "answer", "rb") as file:
            self.json_answer("check", "-", INFEASIBLE, stdin=file.read())
        self.json_answer("check", "answer", "-", stdin=INFEASIBLE)
        self.assert_refused("check", "-", "-", says="both")

    def test_rejects_a_changed_one(self):
        self.certificate["edge"][0] += 1000
        self.write("certificate", json.dumps(self.certificate))
        answer = self.json_answer("check", "certificate", INFEASIBLE, status=1)
        self.assertIs(answer["valid"], False)

    def test_refuses_what_is_no_certificate(self):
        self.write("geometric", self.run_program("solve", TRIPUS, "--json").out)
        cases = {"empty": "", "array": "[]", "deep": "[" * 100000, "word": '{"kind": "some"}',
                 "large": '{"kind": "none", "edge": [1e999], "vertex": []}',
                 "zero": b"\0", "not utf8": b'{"\xff": 1}'}
        for name, content in cases.items():
            with self.subTest(name):
                self.write(name, content)
                self.assert_refused("check", name, INFEASIBLE, says=f'"{name}"')
        self.assert_refused("check", "geometric", TRIPUS, says='"geometric"')
        self.assert_refused("check", "none", INFEASIBLE, says='cannot open "none"')
        self.assert_refused("check", "answer", says="INPUT")
        self.assert_refused("check", "answer", "cPcbbb", says="character 7")
